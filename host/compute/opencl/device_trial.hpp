#pragma once

#include <functional>
#include <string_view>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/device_options.hpp"

namespace lineatlas::compute {

/// Has a driver prove once that its kernels compute what C++ does: `run` is to use a device made by
/// the options that it is given, which compares every kernel. The verdict is kept in the user's
/// cache for this driver and version, these kernels and launch parameters, under the name `what`;
/// where there is no cache (LINEATLAS_CACHE=off) nothing is tried. Devices that are not OpenCL's,
/// or run kernels of the user's own (LINEATLAS_KERNEL_DIR), are not either. Throws BuildError
/// (build_error.hpp) for a kernel that computes something else, or is not built. Returns whether it
/// is known that all do.
bool try_device(const Device& device, std::string_view what,
                const std::function<void(const DeviceOptions&)>& run);

} // namespace lineatlas::compute
