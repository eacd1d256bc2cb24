#pragma once

#include <cstdint>

#include "devices.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// What kernels/tuning.toml says of a device, within what its quirks allow. Throws FileError if
/// that is LINEATLAS_KERNEL_DIR's and not right.
Tuning tuning_for(const OpenClDevice& device);

/// `tuning` with no work-group larger than the device takes, and tiles that fit its local memory.
Tuning within_groups(Tuning tuning, const cl::Device& device);

} // namespace lineatlas::compute
