#include "profiling.hpp"

namespace lineatlas::bench {

std::vector<Drawn> profile_drawings() {
    const FrameOptions plain = method_options(method_spec("SAhi"));
    FrameOptions profiled = plain;
    profiled.profile = true;
    return {{"off", plain}, {"on", profiled}, {"off again", plain}};
}

std::optional<ProfilingCost> profiling_cost(const Report& report) {
    const SceneResult* row = report.scene(profile_row);
    if (row == nullptr) return std::nullopt;
    const Measured* off = row->method("off");
    const Measured* on = row->method("on");
    const Measured* again = row->method("off again");
    if (off == nullptr || on == nullptr || again == nullptr) return std::nullopt;
    return ProfilingCost{.time = paired_ratio(*on, *off),
                         .cpu = paired_cpu_ratio(*on, *off),
                         .time_noise = paired_ratio(*again, *off),
                         .cpu_noise = paired_cpu_ratio(*again, *off),
                         .stages_ms = row->profiled_ms,
                         .frame_ms = on->ms()};
}

} // namespace lineatlas::bench
