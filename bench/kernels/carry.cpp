// carry: n silhouettes in chains (paths.hpp). Every eighth silhouette is new. Every path has moved
// by its own number of pixels since the last frame. Bytes per silhouette: recall 120 (segment 32,
// clipped 48, memory 16, recalled 8, four words), keep 52, list 8, breaks 56, pieces 4, settle 12,
// place 140 (as recall, also carried 8 and four words), and 12 for each of four scans. Bytes per
// run: the run read and written (80 each), its coordinates and its arc length (20).

#include "compute/stages/carried_coordinates.hpp"
#include "paths.hpp"

namespace lineatlas::bench {
namespace {

/// The memory of the last frame, LA_MEMORY_WORDS per silhouette.
std::vector<std::uint32_t> make_memory(const Paths& paths, std::uint32_t frame) {
    std::vector<std::uint32_t> memory;
    for (std::uint32_t i = 0; i < paths.segments.size(); ++i) {
        const Segment& segment = paths.segments[i];
        const std::uint32_t first = paths.arcs[i - segment.from_start];
        const std::uint32_t moved = segment.path % 64 * 256;
        const bool is_new = i % 8 == 0;
        memory.insert(memory.end(),
                      {paths.arcs[i] - first + moved, paths.arcs[i + 1] - first + moved,
                       65535U << 16U, is_new ? 0 : frame << 1U});
    }
    return memory;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    constexpr std::uint32_t before = 5;
    compute::Device& device = stages.device();
    const Paths paths = make_paths(n);
    const PathTables on{device, paths};
    std::vector<std::uint32_t> origin_values;
    for (std::uint32_t i = 0; i < n; ++i) origin_values.push_back((i << 1U) + 1);
    const std::vector<std::uint32_t> memory_values = make_memory(paths, before);
    const SharedBuffer origins = to_device(device, origin_values);
    const auto tables = std::make_shared<compute::CarryTables>(compute::CarryTables{&device});
    tables->make_room(n, n);
    write(device, *tables->memory, memory_values);
    const RunTables runs{device, on.runs};
    compact(stages, on, runs);
    const auto run = [=, &stages] {
        compute::SegmentTable table = on.table();
        table.origins = origins.get();
        stages.carry({.table = table,
                      .first = 0,
                      .count = n,
                      .clipped = on.atlas().clipped,
                      .viewport = Paths::viewport,
                      .frame = before + 1,
                      .limit = 0.4F,
                      .tables = *tables});
        stages.launch<compute::kernels::carry_runs>(
            runs.capacity,
            {.count = runs.capacity, .first = 0, .viewport = {}, .frame = 0, .limit = 0},
            {.arcs = *on.arcs,
             .carried = *tables->carried,
             .record = *runs.record,
             .runs = *runs.runs});
        stages.device().finish();
    };
    run();
    return {.run = run,
            .bytes = 440.0 * n + 180.0 * on.runs,
            .reset = [=, &device] { write(device, *tables->memory, memory_values); },
            .result =
                [=, &device] {
                    return read_back<std::uint8_t>(device, *tables->carried, std::size_t{8} * n);
                }};
}

} // namespace

Rows carry_rows(const Devices& devices) {
    return own_rows(devices, "carry", prepare);
}

} // namespace lineatlas::bench
