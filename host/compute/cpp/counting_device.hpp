#pragma once

#include <memory>
#include <vector>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/kernel_profile.hpp"

namespace lineatlas::compute {

/// Runs every kernel as counting C++, on one thread, and adds the counts of each launch to
/// `counts`, which must outlive the device. Results are those of any other device. `tuning`: of the
/// device whose launches are counted. Its scans are by chunks all the same, since kernels with
/// barriers do not count. Throws UsageError in a build with sanitizers, which has no counting
/// kernels.
std::unique_ptr<Device> make_counting_device(std::vector<LaunchCounts>& counts,
                                             const Tuning& tuning = {});

} // namespace lineatlas::compute
