// From the model to clipped segments with their places in the atlas.
#include <glm/gtc/matrix_inverse.hpp>

#include "stages.hpp"

namespace lineatlas::compute {

void Stages::pyramid(Buffer& depth, glm::ivec2 depth_size, Buffer& tiles) {
    launch<kernels::pyramid>(count_of_tiles(depth_size),
                             {.depth_size = depth_size, .tile_count = tiles_for(depth_size)},
                             {.depth = depth, .tiles = tiles});
}

void Stages::facing(const SegmentTable& table, const glm::vec4& eye, Buffer& front) {
    const std::uint32_t n = table.triangle_count;
    launch<kernels::facing>(n, {.count = n, .eye = eye}, {.front = &front}, table);
}

namespace {

ProjectClipParameters parameters_of(const ProjectClipArgs& args) {
    ProjectClipParameters parameters{.count = args.table.segment_count,
                                     .clip_from_world = args.clip_from_world,
                                     .world_from_clip =
                                         glm::mat4{glm::inverse(glm::dmat4{args.clip_from_world})},
                                     .viewport = args.viewport,
                                     .step = args.step,
                                     .kind_mask = args.kind_mask,
                                     .hidden = LA_HIDDEN_SAMPLED,
                                     .tile_count = {1, 1},
                                     .depth_scale = 1,
                                     .tolerance = 0,
                                     .numbered = args.numbers != nullptr ? 1U : 0U,
                                     .batched = args.batches.count,
                                     .overhang = args.centre_overhang};
    if (const OcclusionTest* test = args.occlusion) {
        parameters.hidden = test->keep_clipped ? LA_HIDDEN_CLIPPED : LA_HIDDEN_DROPPED;
        parameters.tile_count = test->tile_count;
        parameters.depth_scale = test->depth_scale;
        parameters.tolerance = test->tolerance;
    }
    return parameters;
}

struct ScanTables {
    Buffer &values, &sums;
};

Buffer* tiles_of(const ProjectClipArgs& args) {
    return args.occlusion != nullptr ? &args.occlusion->tiles : nullptr;
}

} // namespace

void Stages::project_clip_batches(const ProjectClipArgs& args, bool drops_hidden) {
    ProjectClipParameters parameters = parameters_of(args);
    if (!drops_hidden) parameters.hidden = LA_HIDDEN_SAMPLED;
    launch<kernels::project_clip_batches>(args.batches.batch_count(), parameters,
                                          {.tiles = tiles_of(args)}, args.batches);
}

void Stages::project_clip(const ProjectClipArgs& args) {
    launch<kernels::project_clip>(args.table.segment_count, parameters_of(args),
                                  {.tiles = tiles_of(args), .counts = &args.out.offsets},
                                  args.table, args.batches, args, args.out);
}

void Stages::scan(Buffer& values, std::uint32_t n, ScanKind kind) {
    if (n == 0) {
        device_.clear(values, sizeof(la_uint));
        ++values.writes_;
        return;
    }
    const std::uint32_t variant = kind == ScanKind::saturate ? 1 : 0;
    if (!tuning_.scan_tiles) {
        const std::uint32_t chunks =
            std::max(tuning_.scan_chunks, divide_up(n, tuning_.longest_chunk));
        const ScanParameters parameters{.n = n, .chunk = divide_up(n, chunks), .scanned = 0};
        const ScanTables tables{values, scan_sums_.with_room(chunks)};
        launch_variant<kernels::scan_chunks_reduce>(variant, chunks, 1, parameters, tables);
        launch_variant<kernels::scan_chunks_apply>(variant, chunks, 1, parameters, tables);
        return;
    }
    const std::uint32_t group = tuning_.scan_tile;
    const std::uint32_t items = divide_up(n, tuning_.scan_per_item),
                        tiles = divide_up(items, group);
    ScanParameters parameters{.n = n, .chunk = 0, .scanned = 0};
    constexpr std::uint32_t few_tiles = 4; // one group is done sooner than three launches
    if (tiles <= few_tiles) {
        const ScanTables alone{values, values};
        launch_variant<kernels::scan_tiles_sums>(variant, group, group, parameters, alone);
        return;
    }
    const ScanTables tables{values, scan_sums_.with_room(tiles + std::size_t{1})};
    launch_variant<kernels::scan_tiles_reduce>(variant, items, group, parameters, tables);
    if (tiles > group) {
        launch_variant<kernels::scan_tiles_sums>(variant, group, group,
                                                 {.n = tiles, .chunk = 0, .scanned = 0}, tables);
        parameters.scanned = 1;
    }
    launch_variant<kernels::scan_tiles_apply>(variant, items, group, parameters, tables);
}

} // namespace lineatlas::compute
