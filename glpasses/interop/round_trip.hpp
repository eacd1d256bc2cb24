#pragma once

#include "compute/opencl/opencl_backend.hpp"
#include "sharing.hpp"

namespace lineatlas::interop {

/// Writes a buffer through one API and reads it through the other, both ways. Returns false if the
/// content does not arrive. Throws DeviceError if a call fails.
bool round_trip(compute::Device& device, SharingMode mode);

/// As round_trip(), with a texture that OpenCL has opened.
bool texture_round_trip(compute::OpenClBackend& device);

} // namespace lineatlas::interop
