// Stages of samples: their visibility, its average over time, and the intervals that are read back.
#include <algorithm>

#include "stages.hpp"

namespace lineatlas::compute {

void Stages::atlas(const AtlasArgs& args) {
    constexpr std::uint32_t variants = 4; // of probes per axis, whole and then tiled
    const DepthTile tile = args.tile != nullptr ? *args.tile : DepthTile{};
    const std::uint32_t variant = args.probes - 1 + (args.tile != nullptr ? variants : 0);
    launch_variant<kernels::atlas>(variant, divide_up(args.atlas.capacity, tuning_.atlas_block),
                                   tuning_.block_local_size,
                                   {.count = args.segment_count,
                                    .depth_size = args.depth.size,
                                    .viewport = args.viewport,
                                    .depth_scale = args.depth.scale,
                                    .tolerance = args.depth.tolerance,
                                    .surfaces = args.depth.surface_parameters(),
                                    .capacity = args.atlas.capacity,
                                    .block = tuning_.atlas_block,
                                    .origin = tile.origin,
                                    .core = {tile.core_low, tile.core_high}},
                                   args.atlas.clipped, args.atlas, args.depth.tables());
}

void Stages::temporal(const TemporalArgs& args) {
    const std::uint32_t n = args.segment_count;
    const SegmentAtlas& atlas = args.atlas;
    const ChainOrder* chains = args.chains;
    launch_grouped<kernels::temporal>(
        divide_up(n, tuning_.segment_block), tuning_.block_local_size,
        {.count = n,
         .capacity = atlas.capacity,
         .block = tuning_.segment_block,
         .history = args.use,
         .first = chains != nullptr ? chains->first : n},
        {.offsets_before = &args.history.offsets,
         .before = &args.history.alpha,
         .origins = chains != nullptr ? &chains->origins : nullptr,
         .positions_before = chains != nullptr ? &chains->positions_before : nullptr},
        args.atlas.clipped, args.atlas, args.history);
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
    const IntervalsParameters parameters{.count = n,
                                         .capacity = args.atlas.capacity,
                                         .viewport = args.viewport,
                                         .wanted = args.hidden_too ? 3U : 1U,
                                         .block = tuning_.segment_block,
                                         .blocks = divide_up(n, tuning_.segment_block),
                                         .interval_capacity = args.into.capacity,
                                         .depth_size = args.depth.size,
                                         .depth_scale = args.depth.scale,
                                         .tolerance = args.depth.tolerance,
                                         .surfaces = args.depth.surface_parameters()};
    write_blocks<kernels::intervals_count, kernels::intervals_write>(
        parameters, args.table, args.atlas.clipped, args.atlas, args.into);
    launch<kernels::intervals_refine>(args.into.capacity, parameters, args.table,
                                      args.atlas.clipped, args.depth.tables(), args.into);
}

} // namespace lineatlas::compute
