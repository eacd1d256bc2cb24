#pragma once

#include "compute/opencl/opencl_backend.hpp"
#include "sharing.hpp"

namespace lineatlas::interop {

/// Writes a buffer through one API, reads it through the other, both ways. Throws DeviceError if a
/// call fails; false if the content does not arrive.
bool round_trip(compute::Device& device, SharingMode mode);

/// The same with a texture that OpenCL has opened.
bool texture_round_trip(compute::OpenClBackend& device);

} // namespace lineatlas::interop
