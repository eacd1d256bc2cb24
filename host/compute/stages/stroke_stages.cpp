// `strokes` by kernels: lists runs by tiles of the picture, and draws the tiles.
#include <algorithm>

#include "divide_up.hpp"
#include "stages.hpp"

namespace lineatlas::compute {

std::uint32_t stroke_chunks(const Tuning& tuning, glm::vec2 viewport) {
    // A poster has so many tiles that they alone keep a device busy.
    constexpr std::uint32_t most_ends = 1U << 22U, fewest = 4;
    const glm::ivec2 tiles = stroke_tiles(viewport);
    const auto count = static_cast<std::uint32_t>(tiles.x * tiles.y);
    return std::clamp(most_ends / std::max(count, 1U), fewest,
                      std::max(tuning.face_chunks, fewest));
}

std::size_t stroke_ends(const Tuning& tuning, glm::vec2 viewport) {
    const glm::ivec2 tiles = stroke_tiles(viewport);
    return static_cast<std::size_t>(tiles.x * tiles.y) * stroke_chunks(tuning, viewport) + 1;
}

void Stages::list_strokes(const StrokeListArgs& args) {
    const StrokeListParameters parameters{.tiles = stroke_tiles(args.viewport),
                                          .reach = args.half_width + LA_STROKE_FRINGE,
                                          .chunks = stroke_chunks(tuning_, args.viewport),
                                          .capacity = args.lists.capacity};
    const std::size_t ends = stroke_ends(tuning_, args.viewport);
    device_.clear(args.lists.ends, ends * sizeof(la_uint));
    launch_grouped<kernels::strokes_count>(parameters.chunks, tuning_.block_local_size, parameters,
                                           args, Counts{args.lists.ends});
    scan(args.lists.ends, static_cast<std::uint32_t>(ends - 1), ScanKind::saturate);
    launch_grouped<kernels::strokes_list>(parameters.chunks, tuning_.block_local_size, parameters,
                                          args, args.lists);
}

void Stages::draw_strokes(const StrokeArgs& args) {
    const TileRange tiles = part_tiles(args.part);
    const auto tile_count = static_cast<std::uint32_t>(tiles.count.x * tiles.count.y);
    const bool by_pixels = tuning_.depth_lanes == 1;
    const std::uint32_t items =
        by_pixels ? tile_count * LA_STROKE_TILE * LA_STROKE_TILE : tile_count;
    const std::uint32_t group = by_pixels ? tuning_.local_size : 1;
    StrokesParameters parameters{.tiles = stroke_tiles(args.viewport),
                                 .chunks = stroke_chunks(tuning_, args.viewport),
                                 .capacity = args.lists.capacity,
                                 .first = tiles.first,
                                 .columns = tiles.count,
                                 .part = {args.part.low, args.part.size},
                                 .begin = 0,
                                 .end = 0,
                                 .again = args.again ? 1U : 0U,
                                 .layer = args.layer,
                                 .pitch = args.pitch,
                                 .half_width = args.half_width,
                                 .opacity = args.opacity,
                                 .end_kinds = args.end_kinds,
                                 .hidden = args.hidden ? 1U : 0U,
                                 .pen = args.pen,
                                 .mark_length = args.mark != nullptr ? args.mark_length : 0,
                                 .per_repeat = 1 / args.repeat_length,
                                 .cells = args.weights != nullptr ? density_cells(args.viewport)
                                                                  : glm::ivec2{0},
                                 .per_cell = 1 / static_cast<float>(density_cell(args.viewport))};
    Buffer& unread = args.lists.ends; // any
    // No list has more runs than there are, and no loop is longer than the device allows.
    do {
        parameters.begin = parameters.end;
        parameters.end += std::min(tuning_.longest_chunk, args.run_count - parameters.end);
        launch_grouped<kernels::strokes_tiles>(
            items, group, parameters,
            {.runs = args.runs,
             .ends = args.lists.ends,
             .entries = args.lists.entries,
             .alpha = args.alpha,
             .mark = args.mark != nullptr ? *args.mark : unread,
             .weights = args.weights != nullptr ? *args.weights : unread,
             .coverage = args.coverage,
             .shown = args.shown});
        parameters.again = 1;
    } while (parameters.end < args.run_count);
}

} // namespace lineatlas::compute
