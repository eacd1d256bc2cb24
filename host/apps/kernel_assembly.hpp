#pragma once

#include <string>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::apps {

/// The code that a compiler made of a kernel: first its loops, as comments with how many numbers
/// each works on at once, then all instructions. `device`: an OpenCL device, as
/// find_opencl_devices() takes it; empty: the kernel as C++. Throws UsageError for a kernel without
/// C++, Error without objdump or if a driver returns neither text nor a library, DeviceError if the
/// kernel does not build.
std::string assembly_of(const compute::Kernel& kernel, const std::string& device);

} // namespace lineatlas::apps
