// `depth` by kernels: draws clusters into tiles, in the order of their depth.
#include <algorithm>
#include <string>

#include "lineatlas/error.hpp"
#include "stages.hpp"

namespace lineatlas::compute {
namespace {

/// Triangles are clipped at this many times the picture's half side. The kernel's sums fit for this
/// many texels from side to side.
float guard_band(glm::ivec2 whole_size) {
    constexpr float most_texels = 60'000, widest = 4;
    const auto side = static_cast<float>(std::max(whole_size.x, whole_size.y));
    return std::clamp(most_texels / side, 1.0F, widest);
}

} // namespace

Buffer& Stages::blank_tiles(const DepthArgs& args) {
    if (args.blank != nullptr) return *args.blank;
    const std::size_t words = divide_up(count_of_tiles(args.size), sizeof(la_uint));
    Buffer& blank = depth_.blank_tiles.with_room(words);
    device_.clear(blank, words * sizeof(la_uint));
    return blank;
}

void Stages::depth(const DepthArgs& args) {
    const MeshletTables& model = args.model;
    // One work-item sorts all of them.
    constexpr std::uint32_t rounds_each = 4, rounds_besides = 4 * LA_DEPTH_KEYS;
    if (!tuning_.depth_each &&
        model.count > (tuning_.longest_chunk - rounds_besides) / rounds_each) {
        throw DeviceError("depth: kernels of " + device_.description() + " can't sort a model of " +
                          std::to_string(model.count) +
                          " clusters of triangles; use StageForms::depth raster");
    }
    const auto side = static_cast<int>(tuning_.depth_tile);
    const glm::ivec2 low = args.covered.low / LA_TILE * LA_TILE;
    const glm::ivec2 tiles = (args.covered.high - low + (side - 1)) / side;
    const std::uint32_t stride =
        divide_up(model.count, LA_MESHLET_PADDING) * LA_MESHLET_PADDING + 2 * LA_MESHLET_PADDING;
    DepthParameters parameters{.count = model.count,
                               .clip_from_world = args.clip_from_world,
                               .whole_size = args.whole_size,
                               .origin = args.origin,
                               .depth_size = args.size,
                               .covered = low,
                               .tiles = tiles,
                               .guard = guard_band(args.whole_size),
                               .stride = stride,
                               .begin = 0,
                               .end = 0,
                               .keeps_depth = 0,
                               .chunk = 0,
                               .chunks = 0,
                               .numbered = 0,
                               .finds = LA_FINDS_DEPTHS,
                               .side = side,
                               .lanes = static_cast<la_int>(tuning_.depth_lanes)};
    depth_.places.make_room(std::size_t{model.count} * sizeof(ClusterPlace));
    launch<kernels::depth_bin>(model.count, parameters, depth_, model, args);
    if (tiles.x <= 0 || tiles.y <= 0) return;
    if (tuning_.depth_each) return depth_each(args, parameters);
    // Each launch goes on from the depth that the one before has stored.
    const bool keeps_depth =
        args.depth != nullptr || args.numbers == nullptr || model.count > tuning_.depth_clusters;
    const std::size_t texels =
        keeps_depth ? static_cast<std::size_t>(args.size.x) * static_cast<std::size_t>(args.size.y)
                    : 1;
    parameters.keeps_depth = keeps_depth ? 1 : 0;
    depth_.boxes.with_room(std::size_t{4} * stride);
    for (ScratchTable* table : {&depth_.nearest, &depth_.order}) table->with_room(stride);
    for (ScratchTable* table : {&depth_.total, &depth_.next}) table->with_room(1);
    const struct {
        Buffer *depth, *numbers, *pyramid, *blank;
    } stored{.depth = args.depth != nullptr ? args.depth : &depth_.unasked.with_room(texels),
             .numbers = args.numbers != nullptr ? args.numbers : &depth_.no_numbers.with_room(1),
             .pyramid = &args.tiles,
             .blank = &blank_tiles(args)};
    launch_grouped<kernels::depth_order>(1, 1, parameters, depth_);
    const std::uint32_t workers =
        std::min(tuning_.depth_workers, static_cast<std::uint32_t>(tiles.x * tiles.y));
    do {
        parameters.begin = parameters.end;
        parameters.end =
            parameters.begin + std::min(tuning_.depth_clusters, model.count - parameters.begin);
        device_.clear(*depth_.next, sizeof(la_uint));
        launch_variant<kernels::depth_tiles>(args.numbers != nullptr ? 1 : 0, workers, 1,
                                             parameters, stored, depth_, model, args);
    } while (parameters.end < model.count);
}

void Stages::order_clusters(DepthParameters& parameters) {
    constexpr std::uint32_t fewest_each = 64, most_chunks = 256;
    parameters.chunk = std::max(divide_up(parameters.count, most_chunks), fewest_each);
    parameters.chunks = divide_up(parameters.count, parameters.chunk);
    const std::uint32_t count = LA_DEPTH_KEYS * parameters.chunks;
    Buffer& counts = depth_.key_counts.with_room(std::size_t{count} + 1);
    device_.clear(counts, std::size_t{count} * sizeof(la_uint));
    launch<kernels::depth_keys>(parameters.chunks, parameters, {.counts = &counts}, depth_);
    scan(counts, count, ScanKind::saturate);
    launch<kernels::depth_positions>(parameters.chunks, parameters, {.counts = &counts}, depth_);
}

void Stages::depth_each(const DepthArgs& args, DepthParameters parameters) {
    const MeshletTables& model = args.model;
    const bool numbered = args.numbers != nullptr;
    const auto texels = static_cast<std::uint32_t>(args.size.x * args.size.y);
    const std::uint32_t triangles = model.count * LA_MESHLET_TRIANGLES;
    for (ScratchTable* table : {&depth_.positions, &depth_.order})
        table->with_room(numbered ? model.count : 1);
    depth_.texels.with_room(std::size_t{2} * texels);
    depth_.large_count.with_room(1);
    depth_.large_list.with_room(triangles);
    parameters.keeps_depth = args.depth != nullptr ? 1 : 0;
    parameters.numbered = numbered ? 1 : 0;
    launch<kernels::depth_begin>(texels, parameters, depth_);
    if (numbered) order_clusters(parameters);
    device_.clear(*depth_.large_count, sizeof(la_uint));
    const std::uint32_t sharers =
        std::min(tuning_.depth_workers, std::max(triangles, 1U)) * LA_DEPTH_SHARE;
    const auto find = [&](la_uint finds) {
        parameters.finds = finds;
        launch<kernels::depth_small>(triangles, parameters, depth_, model, args);
        launch<kernels::depth_large>(sharers, parameters, depth_, model, args);
        launch<kernels::depth_pairs>(sharers, parameters, depth_, model, args);
    };
    find(numbered && tuning_.long_atomics ? LA_FINDS_BOTH : LA_FINDS_DEPTHS);
    if (numbered && !tuning_.long_atomics) find(LA_FINDS_RANKS);
    const auto blocks = static_cast<std::uint32_t>(parameters.tiles.x * parameters.tiles.y) *
                        divide_up(tuning_.depth_tile, LA_TILE) *
                        divide_up(tuning_.depth_tile, LA_TILE);
    launch<kernels::depth_end>(
        blocks, parameters,
        {.depth = args.depth != nullptr ? args.depth : &depth_.unasked.with_room(1),
         .numbers = numbered ? args.numbers : &depth_.no_numbers.with_room(1),
         .pyramid = &args.tiles,
         .blank = &blank_tiles(args)},
        depth_, model, args);
    // Numbers say of each texel which cluster is seen there.
    if (!numbered)
        launch<kernels::depth_seen>(model.count, parameters, {.pyramid = &args.tiles}, depth_,
                                    args);
}

} // namespace lineatlas::compute
