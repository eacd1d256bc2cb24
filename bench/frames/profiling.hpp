#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "report.hpp"
#include "row.hpp"

// The cost of profiling, and the check that the stages of a profile add up to the frame.
namespace lineatlas::bench {

/// The row's name in the report.
inline constexpr std::string_view profile_row = "profile";

/// SAhi without profile ("off"), the same once more ("off again", which shows the noise), and
/// profiled ("on").
std::vector<Drawn> profile_drawings();

struct ProfilingCost {
    double time, cpu;             ///< of a profiled frame, over that of an unprofiled one
    double time_noise, cpu_noise; ///< of one unprofiled frame over another
    double stages_ms;             ///< median sum of the stages of profiled frames
    double frame_ms;              ///< median time of those frames by the benchmark's clock
};
/// The cost of profiling; nothing if it was not measured.
std::optional<ProfilingCost> profiling_cost(const Report& report);

} // namespace lineatlas::bench
