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

namespace {

/// The tables of the frame before.
struct BeforeTables {
    Buffer &offsets_before, &before;
    Buffer *origins = nullptr, *positions_before = nullptr; ///< of chains, if there are any
};

} // namespace

void Stages::temporal(const TemporalArgs& args) {
    const std::uint32_t n = args.segment_count;
    const SegmentAtlas& atlas = args.atlas;
    const ChainOrder* chains = args.chains;
    BeforeTables before{args.history.offsets, args.history.alpha};
    if (chains != nullptr) {
        before.origins = &chains->origins;
        before.positions_before = &chains->positions_before;
    }
    launch_grouped<kernels::temporal>(divide_up(n, tuning_.segment_block), tuning_.block_local_size,
                                      {.count = n,
                                       .capacity = atlas.capacity,
                                       .block = tuning_.segment_block,
                                       .history = args.use,
                                       .first = chains != nullptr ? chains->first : n},
                                      args.atlas.clipped, args.atlas, args.history, before);
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
    const IntervalsParameters parameters{.count = n,
                                         .capacity = args.atlas.capacity,
                                         .viewport = args.viewport,
                                         .wanted = args.hidden_too ? 3U : 1U,
                                         .block = tuning_.segment_block,
                                         .blocks = blocks,
                                         .interval_capacity = args.into.capacity,
                                         .depth_size = args.depth.size,
                                         .depth_scale = args.depth.scale,
                                         .tolerance = args.depth.tolerance,
                                         .surfaces = args.depth.surface_parameters()};
    const std::uint32_t items = std::max(blocks, 1U); // the first work-item writes the total
    Buffer& counts = scratch(Scratch::block_counts, blocks + 1);
    launch_grouped<kernels::intervals_count>(items, tuning_.block_local_size, parameters,
                                             args.table, args.atlas.clipped, args.atlas,
                                             Counts{counts});
    scan(counts, blocks, ScanKind::saturate);
    launch_grouped<kernels::intervals_write>(items, tuning_.block_local_size, parameters,
                                             args.table, args.atlas.clipped, args.atlas, args.into,
                                             BlockOffsets{counts});
    launch<kernels::intervals_refine>(args.into.capacity, parameters, args.table,
                                      args.atlas.clipped, args.depth.tables(), args.into);
}

} // namespace lineatlas::compute
