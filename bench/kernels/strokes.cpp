// strokes in the compute form: the visible runs of n segments in paths (paths.hpp), 2 pixels wide.
// Bytes: per run the run three times (240), for counting, listing and drawing, and its entry
// written and read (8); per sample 1; per pixel 1.

#include <algorithm>

#include "paths.hpp"

namespace lineatlas::bench {
namespace {

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Paths paths = make_paths(n);
    const PathTables on{device, paths};
    const RunTables from{device, on.runs};
    compact(stages, on, from);
    const PictureTile part{{0, 0}, glm::ivec2{Paths::viewport}};
    const auto pixels = static_cast<std::uint32_t>(part.size.x * part.size.y);
    const glm::ivec2 tiles = compute::part_tiles(part).count;
    const std::size_t bytes = sizeof(std::uint32_t);
    const std::uint32_t capacity = 4 * on.runs + 4; // runs so short reach at most 4 tiles
    const SharedBuffer ends =
        device.allocate(compute::stroke_ends(device.tuning(), Paths::viewport) * bytes);
    const SharedBuffer entries = device.allocate(capacity * bytes);
    const SharedBuffer total = device.allocate(bytes);
    const SharedBuffer coverage = device.allocate(pixels);
    const SharedBuffer shown = device.allocate(static_cast<std::size_t>(tiles.x * tiles.y) * bytes);
    const auto run = [=, &stages] {
        const compute::StrokeLists lists{*ends, *entries, *total, capacity};
        const compute::RunTable runs{*from.runs, *from.record, on.runs};
        stages.list_strokes(
            {.runs = runs, .viewport = Paths::viewport, .half_width = 1, .lists = lists});
        stages.draw_strokes({.runs = runs,
                             .lists = lists,
                             .alpha = *on.alpha,
                             .viewport = Paths::viewport,
                             .part = part,
                             .half_width = 1,
                             .opacity = 0.5F,
                             .end_kinds = LA_STROKES_ROUND_PATHS,
                             .coverage = *coverage,
                             .shown = *shown,
                             .layer = 0,
                             .pitch = pixels});
        stages.device().finish();
    };
    run();
    const auto result = [&device, coverage, pixels] {
        std::vector<float> values;
        for (const std::uint8_t value : read_back<std::uint8_t>(device, *coverage, pixels))
            values.push_back(value);
        return values;
    };
    const std::vector<float> found = result();
    const auto drawn = std::ranges::count_if(found, [](float value) { return value > 100; });
    // Every run darkens at least one pixel, as long as few runs cover one another.
    require(drawn > std::min<std::ptrdiff_t>(on.runs, pixels / 4), "strokes");
    return {.run = run, .bytes = 248.0 * on.runs + on.samples + pixels, .result = result};
}

} // namespace

Rows strokes_rows(const Devices& devices) {
    return own_rows(devices, "strokes", prepare);
}

} // namespace lineatlas::bench
