#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/kernel_profile.hpp"
#include "perf_events.hpp"

namespace lineatlas::compute {

/// The device that profiles name: "cpp", also if empty, or an OpenCL device. Throws UsageError for
/// another kind.
std::unique_ptr<Device> make_measured_device(std::string_view name);

/// Runs every kernel on `device`, waits for it, and adds what the CPU counted and the driver tells
/// to `counts`, which must outlive the device. `events`: those of PerfCounts, in the order of
/// cpu_events().
std::unique_ptr<Device> make_perf_device(std::unique_ptr<Device> device,
                                         std::span<const PerfEvent> events,
                                         std::vector<PerfCounts>& counts);

} // namespace lineatlas::compute
