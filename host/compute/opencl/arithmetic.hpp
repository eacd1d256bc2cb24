#pragma once

#include "opencl_backend.hpp"

namespace lineatlas::compute {

/// Roofs::arithmetic of a device; 0 if its compiler refuses the kernel that measures. Throws
/// DeviceError if the device fails.
double measure_arithmetic(const OpenClBackend& backend);

} // namespace lineatlas::compute
