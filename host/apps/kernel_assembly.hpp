#pragma once

#include <string>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::apps {

/// What the compiler made of a kernel: its loops, with how many numbers each works on at once, as
/// lines of comments; then all its instructions. `device`: of OpenCL, as find_opencl_devices takes
/// it; empty: the kernel as C++. Throws UsageError for a kernel that has no C++, Error without
/// objdump or where a driver hands out neither text nor a library, DeviceError if it does not
/// build.
std::string assembly_of(const compute::Kernel& kernel, const std::string& device);

} // namespace lineatlas::apps
