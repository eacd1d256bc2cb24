// filter: the visible runs of n segments in paths (paths.hpp), with holes closed, short runs
// dropped, and ends that overshoot. Bytes: per run the run (80), its segment (32), its clipped
// segment (48), its offset and its arc length (8), each of these twice, for counting and for
// writing; per resulting run 80; per sample 1.

#include "paths.hpp"

namespace lineatlas::bench {
namespace {

constexpr StrokeFilter filter{
    .fill_holes = 5, .drop_runs = 5, .overshoot = 4, .overshoot_variation = 0.5F};

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Paths paths = make_paths(n);
    const PathTables on{device, paths};
    const RunTables from{device, on.runs}, to{device, 2 * on.runs};
    compact(stages, on, from);
    const auto run = [&stages, on, from, to] {
        stages.filter({.table = on.table(),
                       .atlas = on.atlas(),
                       .viewport = Paths::viewport,
                       .half_width = 1,
                       .filter = filter,
                       .runs = {*from.runs, *from.record, from.capacity},
                       .cuts = nullptr,
                       .filtered = {*to.runs, *to.record, to.capacity}});
        stages.device().finish();
    };
    run();
    const auto result = [&device, to] { return members(to.read(device), &Run::segment); };
    const double written = static_cast<double>(to.read(device).size());
    return {.run = run,
            .bytes = 336.0 * on.runs + 80.0 * written + on.samples,
            .reset = [&device, on, alpha = paths.alpha] { write(device, *on.alpha, alpha); },
            .result = result};
}

} // namespace

Rows filter_rows(const Devices& devices) {
    return own_rows(devices, "filter", prepare);
}

} // namespace lineatlas::bench
