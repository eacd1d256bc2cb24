#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "report.hpp"
#include "row.hpp"

// What profiling costs, and whether the stages of a profile add up to the frame.
namespace lineatlas::bench {

/// The row's name in the report.
inline constexpr std::string_view profile_row = "profile";

/// SAhi twice as it is ("off", "off again": how far two equal ones lie apart) and profiled ("on").
std::vector<Drawn> profile_drawings();

struct ProfilingCost {
    double time, cpu;             ///< of a frame, over that of one without
    double time_noise, cpu_noise; ///< the same of one without, over another
    double stages_ms;             ///< what the stages of profiled frames add up to, median
    double frame_ms;              ///< of those frames by the benchmark's own clock, median
};
/// Nothing if not measured.
std::optional<ProfilingCost> profiling_cost(const Report& report);

} // namespace lineatlas::bench
