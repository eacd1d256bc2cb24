#pragma once

#include <cstddef>
#include <string>

#include "devices.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// The values of kernels/tuning.toml for a device, within the limits of its quirks. Throws
/// FileError if the table in LINEATLAS_KERNEL_DIR is wrong.
Tuning tuning_for(const OpenClDevice& device);

/// The limits of a work-group on a device.
struct GroupLimits {
    std::size_t items = 0;        ///< work-items
    std::size_t local_memory = 0; ///< bytes
};
GroupLimits group_limits(const cl::Device& device);

/// `tuning` changed so that work-groups are no larger than the device allows, and tiles fit its
/// local memory.
Tuning within_groups(Tuning tuning, const GroupLimits& limits);

/// Compiler options for kernels that are launched by `tuning`.
std::string compiler_options(const Tuning& tuning);

} // namespace lineatlas::compute
