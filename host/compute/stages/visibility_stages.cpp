// Samples: their visibility, over time, and what is read back of it.
#include <algorithm>

#include "divide_up.hpp"
#include "stages.hpp"

namespace lineatlas::compute {
namespace {

// Any tables of their type where surfaces are not known: they are not read.
Buffer& patches_or(const DepthBuffer& depth, Buffer& other) {
    return depth.surfaces ? depth.surfaces->patches : other;
}
Buffer& planes_of(const DepthBuffer& depth) {
    return depth.surfaces ? depth.surfaces->planes : depth.texels;
}

} // namespace

void Stages::atlas(const AtlasArgs& args) {
    constexpr std::uint32_t variants = 4; // of probes per axis, whole and then tiled
    const DepthTile tile = args.tile != nullptr ? *args.tile : DepthTile{};
    const std::uint32_t variant = args.probes - 1 + (args.tile != nullptr ? variants : 0);
    launch<kernels::atlas>(divide_up(args.atlas.capacity, tuning_.atlas_block),
                           tuning_.block_local_size,
                           {.count = args.segment_count,
                            .depth_size = args.depth.size,
                            .viewport = args.viewport,
                            .depth_scale = args.depth.scale,
                            .tolerance = args.depth.tolerance,
                            .surfaces = args.depth.surface_parameters(),
                            .rows = args.atlas.rows(),
                            .block = tuning_.atlas_block,
                            .origin = tile.origin,
                            .core = {tile.core_low, tile.core_high}},
                           {.clipped = args.atlas.clipped.clipped,
                            .offsets = args.atlas.clipped.offsets,
                            .depth = args.depth.texels,
                            .numbers = args.depth.numbers_or(args.atlas.clipped.offsets),
                            .planes = planes_of(args.depth),
                            .patches = patches_or(args.depth, args.atlas.clipped.offsets),
                            .alpha = args.atlas.alpha},
                           kernel_of<kernels::atlas>(variant));
}

void Stages::temporal(const TemporalArgs& args) {
    const std::uint32_t n = args.segment_count;
    const SegmentAtlas& atlas = args.atlas;
    const ChainOrder* chains = args.chains;
    launch<kernels::temporal>(
        divide_up(n, tuning_.segment_block), tuning_.block_local_size,
        {.count = n,
         .rows = atlas.rows(),
         .block = tuning_.segment_block,
         .history = args.use,
         .first = chains != nullptr ? chains->first : n},
        {.clipped = atlas.clipped.clipped,
         .offsets = atlas.clipped.offsets,
         .offsets_before = args.history.offsets,
         .before = args.history.alpha,
         // Any table will do where there are no chains.
         .origins = chains != nullptr ? chains->origins : atlas.clipped.offsets,
         .positions_before = chains != nullptr ? chains->positions_before : atlas.clipped.offsets,
         .ranges = args.history.ranges,
         .alpha = atlas.alpha});
    if (chains != nullptr) {
        device_.copy(chains->positions, chains->positions_before,
                     std::size_t{chains->candidates} * sizeof(la_uint));
    }
    device_.copy(atlas.clipped.offsets, args.history.offsets,
                 (std::size_t{n} + 1) * sizeof(la_uint));
    device_.copy(atlas.alpha, args.history.alpha,
                 std::min(atlas.alpha.size(), args.history.alpha.size()));
}

void Stages::intervals(const IntervalsArgs& args) {
    const std::uint32_t n = args.table.segment_count;
    const std::uint32_t blocks = divide_up(n, tuning_.segment_block);
    const ClippedTable& clipped = args.atlas.clipped;
    const IntervalsParameters parameters{.count = n,
                                         .rows = args.atlas.rows(),
                                         .viewport = args.viewport,
                                         .wanted = args.hidden_too ? 3U : 1U,
                                         .block = tuning_.segment_block,
                                         .blocks = blocks,
                                         .interval_capacity = args.interval_capacity,
                                         .depth_size = args.depth.size,
                                         .depth_scale = args.depth.scale,
                                         .tolerance = args.depth.tolerance,
                                         .surfaces = args.depth.surface_parameters()};
    const std::uint32_t items = std::max(blocks, 1U); // the first writes the total
    Buffer& counts = scratch(block_counts_, blocks + 1);
    launch<kernels::intervals_count>(items, tuning_.block_local_size, parameters,
                                     {.segments = args.table.segments,
                                      .clipped = clipped.clipped,
                                      .offsets = clipped.offsets,
                                      .arcs = clipped.arcs,
                                      .alpha = args.atlas.alpha,
                                      .counts = counts});
    scan(counts, blocks, ScanKind::saturate);
    launch<kernels::intervals_write>(items, tuning_.block_local_size, parameters,
                                     {.segments = args.table.segments,
                                      .clipped = clipped.clipped,
                                      .offsets = clipped.offsets,
                                      .arcs = clipped.arcs,
                                      .alpha = args.atlas.alpha,
                                      .block_offsets = counts,
                                      .intervals = args.intervals,
                                      .interval_total = args.total});
    launch<kernels::intervals_refine>(args.interval_capacity, tuning_.local_size, parameters,
                                      {.segments = args.table.segments,
                                       .clipped = clipped.clipped,
                                       .offsets = clipped.offsets,
                                       .arcs = clipped.arcs,
                                       .vertices = args.table.vertices,
                                       .depth = args.depth.texels,
                                       .numbers = args.depth.numbers_or(clipped.offsets),
                                       .planes = planes_of(args.depth),
                                       .patches = patches_or(args.depth, clipped.offsets),
                                       .intervals = args.intervals,
                                       .interval_total = args.total});
}

} // namespace lineatlas::compute
