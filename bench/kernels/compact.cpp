// compact: n segments in paths (paths.hpp). Bytes: per segment its offset (4); per sample its alpha
// (1); per run the run (80), its segment (32), its clipped segment (48) and an arc length (4).

#include <algorithm>

#include "paths.hpp"

namespace lineatlas::bench {
namespace {

double bytes_of(const Paths& input) {
    return 4.0 * static_cast<double>(input.offsets.size()) +
           static_cast<double>(input.alpha.size()) + 164.0 * static_cast<double>(input.runs.size());
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Paths paths = make_paths(n);
    const PathTables on{device, paths};
    const RunTables to{device, on.runs};
    const auto run = [&stages, on, to] { compact(stages, on, to); };
    run();
    const std::vector<Run> found = to.read(device);
    require(std::ranges::equal(found, paths.runs, {}, &Run::segment), "compact");
    return {.run = run, .bytes = bytes_of(paths), .result = [&device, to] {
                return members(to.read(device), &Run::segment);
            }};
}

} // namespace

Rows compact_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "compact", prepare);
    rows.push_back(
        copy_row(devices, "compact", [](std::uint32_t n) { return bytes_of(make_paths(n)); }));
    return rows;
}

} // namespace lineatlas::bench
