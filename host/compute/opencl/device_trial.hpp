#pragma once

#include <functional>
#include <string_view>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/device_options.hpp"

namespace lineatlas::compute {

/// Checks once that a driver's kernels compute what C++ does. `run` gets device options and must
/// use a device made by them, which compares every kernel. The verdict is kept in the user's cache
/// for this driver and version, these kernels and launch parameters, under the name `what`. Nothing
/// is tried without a cache (LINEATLAS_CACHE=off), for devices that are not OpenCL's, or with
/// kernels of the user's own (LINEATLAS_KERNEL_DIR). Throws BuildError (build_error.hpp) for a
/// kernel with wrong results or one that is not built. Returns true if all kernels are known to be
/// right.
bool try_device(const Device& device, std::string_view what,
                const std::function<void(const DeviceOptions&)>& run);

} // namespace lineatlas::compute
