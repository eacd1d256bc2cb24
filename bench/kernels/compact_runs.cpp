// compact_runs: n segments in paths (paths.hpp). Bytes: per segment its offset (4); per sample 1;
// per run the run (64), its segment (32), its clipped segment (48) and an arc length (4).

#include <algorithm>

#include "common.hpp"
#include "paths.hpp"

namespace lineatlas::bench {
namespace {

double bytes_of(const Paths& input) {
    return 4.0 * static_cast<double>(input.offsets.size()) +
           static_cast<double>(input.alpha.size()) + 148.0 * static_cast<double>(input.runs.size());
}

void check(compute::Backend& backend, const Paths& input, compute::Buffer& runs,
           compute::Buffer& record) {
    require(read_back<FrameRecord>(backend, record, 1)[0].run_total == input.runs.size(),
            "compact_runs");
    const auto found = read_back<Run>(backend, runs, input.runs.size());
    require(std::ranges::equal(found, input.runs, {}, &Run::segment), "compact_runs");
}

Job prepare(compute::Backend& backend, std::uint32_t n) {
    const Paths input = make_paths(n);
    const SharedBuffer none = backend.allocate(sizeof(glm::vec4)); // it reads no mesh
    const SharedBuffer segments = to_device(backend, input.segments);
    const SharedBuffer clipped = to_device(backend, input.clipped);
    const SharedBuffer offsets = to_device(backend, input.offsets);
    const SharedBuffer arcs = to_device(backend, input.arcs);
    const SharedBuffer alpha = to_device(backend, input.alpha);
    const auto run_count = static_cast<std::uint32_t>(input.runs.size());
    const auto samples = static_cast<std::uint32_t>(input.alpha.size());
    const SharedBuffer runs = backend.allocate(run_count * sizeof(Run));
    const SharedBuffer record = backend.allocate(sizeof(FrameRecord));
    const AtlasLayout layout = make_atlas_layout(AtlasLayoutKind::wrap, 7, 16384);
    const auto run = [=, &backend] {
        backend.compact_runs({.table = {*none, *none, *segments, 0, n},
                              .clipped = {*clipped, *offsets, *arcs},
                              .alpha = *alpha,
                              .layout = layout,
                              .capacity = samples,
                              .viewport = Paths::viewport,
                              .half_width = 1,
                              .runs = *runs,
                              .run_capacity = run_count,
                              .record = *record});
        backend.finish();
    };
    run();
    check(backend, input, *runs, *record);
    return {.run = run, .bytes = bytes_of(input)};
}

} // namespace

Rows compact_runs_rows(const Backends& backends) {
    Rows rows = own_rows(backends, "compact_runs", prepare);
    rows.push_back(copy_row(backends, "compact_runs",
                            [](std::uint32_t n) { return bytes_of(make_paths(n)); }));
    return rows;
}

} // namespace lineatlas::bench
