// `strokes` by kernels: lists runs by tiles of the picture, and draws the tiles.
#include <algorithm>

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
                                           {.counts = &args.lists.ends}, args.runs);
    scan(args.lists.ends, static_cast<std::uint32_t>(ends - 1), ScanKind::saturate);
    launch_grouped<kernels::strokes_list>(parameters.chunks, tuning_.block_local_size, parameters,
                                          args.runs, args.lists);
}

void Stages::draw_strokes(const StrokeArgs& args) {
    const TileRange tiles = part_tiles(args.part);
    const auto tile_count = static_cast<std::uint32_t>(tiles.count.x * tiles.count.y);
    const std::uint32_t run_count = args.runs.capacity; // or fewer
    StrokesParameters parameters{.count = run_count,
                                 .tiles = stroke_tiles(args.viewport),
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
    constexpr std::size_t box_words = sizeof(StrokeBox) / sizeof(la_uint);
    Buffer& boxes = stroke_boxes_.with_room(tuning_.stroke_pixels ? run_count * box_words : 1);
    if (tuning_.stroke_pixels)
        launch<kernels::strokes_boxes>(run_count, parameters, {.boxes = &boxes}, args.runs, args);
    // No list is longer than all runs are; no loop than the device allows.
    do {
        parameters.begin = parameters.end;
        parameters.end += std::min(tuning_.longest_chunk, run_count - parameters.end);
        if (tuning_.stroke_pixels) {
            const std::uint32_t pixels = LA_STROKE_TILE * LA_STROKE_TILE / tuning_.depth_lanes;
            launch<kernels::strokes_pixels>(tile_count * pixels, parameters, {.boxes = &boxes},
                                            args.runs, args, args.lists);
        } else {
            launch_grouped<kernels::strokes_tiles>(tile_count, 1, parameters, args.runs, args,
                                                   args.lists);
        }
        parameters.again = 1;
    } while (parameters.end < run_count);
}

} // namespace lineatlas::compute
