#include "reference_backend.hpp"

#include <algorithm>
#include <exception>

#include "core/limits.hpp"
#include "stages.hpp"

namespace lineatlas::compute {

std::string ReferenceBackend::description() const {
    return "reference";
}

std::unique_ptr<Buffer> ReferenceBackend::allocate(std::size_t bytes) {
    try {
        return std::make_unique<HostBuffer>(std::max<std::size_t>(bytes, 16));
    } catch (const std::exception&) { // bad_alloc, or length_error of a vector
        throw Shortage(written_bytes(bytes), "the host has not that much");
    }
}

std::unique_ptr<Buffer> ReferenceBackend::wrap(std::span<std::byte> memory) {
    return std::make_unique<HostBuffer>(memory);
}

void ReferenceBackend::begin_host_access(Buffer&) {}

void ReferenceBackend::end_host_access(Buffer&) {}

void ReferenceBackend::upload(Buffer& buffer, std::span<const std::byte> data) {
    std::ranges::copy(data, memory_of(buffer).begin());
}

void ReferenceBackend::upload_at(Buffer& buffer, std::size_t offset,
                                 std::span<const std::byte> data) {
    std::ranges::copy(data, memory_of(buffer).subspan(offset).begin());
}

void ReferenceBackend::download(Buffer& buffer, std::span<std::byte> data) {
    std::ranges::copy(memory_of(buffer).first(data.size()), data.begin());
}

void ReferenceBackend::transform(const TransformArgs& args) {
    const std::size_t n = args.vertex_count, clusters = args.cluster_count;
    const auto matrices = view_all<float>(args.matrices);
    const auto vertices = view<glm::vec3>(args.vertices, n);
    reference::transform(view<glm::vec3>(args.rest, n), view<std::uint32_t>(args.objects, n),
                         matrices, vertices);
    std::ranges::copy(vertices, view<glm::vec3>(args.drawn, n).begin());
    reference::transform_boxes(view<Cluster>(args.rest_clusters, clusters),
                               view<std::uint32_t>(args.cluster_objects, clusters), matrices,
                               view<Cluster>(args.clusters, clusters));
}

void ReferenceBackend::bounds(const BoundsArgs& args) {
    reference::transform_bounds(view_all<glm::vec3>(args.vertices),
                                view_all<std::uint32_t>(args.triangles),
                                view<Cluster>(args.clusters, args.count));
}

void ReferenceBackend::forget(const ForgetArgs& args) {
    const std::size_t n = args.segment_count;
    reference::transform_forget(
        view<Segment>(args.segments, n), view_all<std::uint32_t>(args.objects),
        view_all<std::uint8_t>(args.jumped), view<std::uint32_t>(args.ranges, n));
}

void ReferenceBackend::pyramid(const PyramidArgs& args) {
    reference::pyramid(view_all<float>(args.depth), args.depth_size, view_all<float>(args.tiles));
}

void ReferenceBackend::cull(const CullArgs& args) {
    reference::cull(view<Cluster>(args.clusters, args.count), args.clip_from_world, args.depth_size,
                    view_all<float>(args.tiles), view<std::uint8_t>(args.visible, args.count));
}

void ReferenceBackend::facing(const FacingArgs& args) {
    const std::size_t triangles = args.table.triangle_count;
    reference::facing(view_all<float>(args.table.vertices),
                      view<std::uint32_t>(args.table.triangles, 3 * triangles), args.eye,
                      view<std::uint8_t>(args.front, triangles));
}

void ReferenceBackend::project_clip(const ProjectClipArgs& args) {
    const std::size_t n = args.table.segment_count;
    const OcclusionTest* occlusion = args.occlusion;
    reference::project_clip(
        {.segments = view<Segment>(args.table.segments, n),
         .vertices = view_all<float>(args.table.vertices),
         .triangles = view_all<std::uint32_t>(args.table.triangles),
         .front = view_all<std::uint8_t>(args.front),
         .clip_from_world = args.clip_from_world,
         .world_from_clip = args.world_from_clip,
         .viewport = args.viewport,
         .step = args.step,
         .kind_mask = args.kind_mask,
         .tiles = occlusion ? view_all<float>(occlusion->tiles) : std::span<float>{},
         .tile_count = occlusion ? occlusion->tile_count : glm::ivec2{0},
         .depth_scale = occlusion ? occlusion->depth_scale : 1,
         .tolerance = occlusion ? occlusion->tolerance : 0,
         .keep_clipped = occlusion && occlusion->keep_clipped},
        view<ClippedSegment>(args.out.clipped, n), view<std::uint32_t>(args.out.offsets, n),
        view<std::uint32_t>(args.out.arcs, n));
}

void ReferenceBackend::scan(Buffer& values, std::uint32_t n, ScanKind kind) {
    reference::scan(view<std::uint32_t>(values, std::size_t{n} + 1), kind);
}

void ReferenceBackend::atlas(const AtlasArgs& args) {
    const std::size_t n = args.segment_count;
    reference::atlas({.clipped = view<ClippedSegment>(args.clipped.clipped, n),
                      .offsets = view<std::uint32_t>(args.clipped.offsets, n + 1),
                      .depth = view_all<float>(args.depth),
                      .depth_size = args.depth_size,
                      .viewport = args.viewport,
                      .depth_scale = args.depth_scale,
                      .probes = args.probes,
                      .tolerance = args.tolerance,
                      .layout = args.layout,
                      .capacity = args.capacity,
                      .tile = args.tile},
                     view_all<std::uint8_t>(args.alpha));
}

void ReferenceBackend::temporal(const TemporalArgs& args) {
    const std::size_t n = args.segment_count;
    const auto offsets = view<std::uint32_t>(args.clipped.offsets, n + 1);
    const auto offsets_before = view<std::uint32_t>(args.history.offsets, n + 1);
    const auto alpha = view_all<std::uint8_t>(args.alpha);
    const auto before = view_all<std::uint8_t>(args.history.alpha);
    reference::temporal(
        {.clipped = view<ClippedSegment>(args.clipped.clipped, n),
         .offsets = offsets,
         .offsets_before = args.use_history ? offsets_before : std::span<std::uint32_t>{},
         .layout = args.layout,
         .capacity = args.capacity,
         .before = before},
        view<std::uint32_t>(args.history.ranges, n), alpha);
    std::ranges::copy(offsets, offsets_before.begin());
    std::ranges::copy(alpha.first(std::min(alpha.size(), before.size())), before.begin());
}

void ReferenceBackend::compact_runs(const CompactRunsArgs& args) {
    const std::size_t n = args.table.segment_count;
    reference::compact_runs({.segments = view<Segment>(args.table.segments, n),
                             .clipped = view<ClippedSegment>(args.clipped.clipped, n),
                             .offsets = view<std::uint32_t>(args.clipped.offsets, n + 1),
                             .arcs = view<std::uint32_t>(args.clipped.arcs, n + 1),
                             .alpha = view_all<std::uint8_t>(args.alpha),
                             .layout = args.layout,
                             .capacity = args.capacity,
                             .viewport = args.viewport,
                             .half_width = args.half_width,
                             .hidden = args.hidden},
                            view<Run>(args.runs, args.run_capacity),
                            view<FrameRecord>(args.record, 1)[0]);
}

void ReferenceBackend::filter(const FilterArgs& args) {
    const std::size_t n = args.table.segment_count;
    const FrameRecord& record = view<FrameRecord>(args.record, 1)[0];
    const std::size_t runs = record.points[0];
    const auto alpha = view_all<std::uint8_t>(args.alpha);
    reference::filter(
        {.segments = view<Segment>(args.table.segments, n),
         .clipped = view<ClippedSegment>(args.clipped.clipped, n),
         .offsets = view<std::uint32_t>(args.clipped.offsets, n + 1),
         .arcs = view<std::uint32_t>(args.clipped.arcs, n + 1),
         .alpha = alpha,
         .layout = args.layout,
         .capacity = args.capacity,
         .viewport = args.viewport,
         .half_width = args.half_width,
         .fill = args.fill,
         .drop = args.drop,
         .overshoot = args.overshoot,
         .overshoot_variation = args.overshoot_variation,
         .undershoot = args.undershoot,
         .runs = view<Run>(args.runs, runs),
         .cuts = args.cuts != nullptr ? view<RunCuts>(*args.cuts, runs) : std::span<RunCuts>{}},
        alpha, view<Run>(args.filtered, args.filtered_capacity), record,
        view<FrameRecord>(args.filtered_record, 1)[0]);
}

void ReferenceBackend::halo(const HaloArgs& args) {
    const std::size_t n = args.table.segment_count;
    const std::size_t count = view<FrameRecord>(args.record, 1)[0].points[0];
    reference::halo({.segments = view<Segment>(args.table.segments, n),
                     .clipped = view<ClippedSegment>(args.clipped.clipped, n),
                     .runs = view<Run>(args.runs, count),
                     .viewport = args.viewport,
                     .width = args.halo + args.half_width,
                     .tolerance = args.tolerance},
                    view<RunCuts>(args.cuts, count));
}

void ReferenceBackend::density(const DensityArgs& args) {
    const std::size_t n = args.table.segment_count;
    const std::size_t count = view<FrameRecord>(args.record, 1)[0].points[0];
    reference::density({.segments = view<Segment>(args.table.segments, n),
                        .arcs = view<std::uint32_t>(args.clipped.arcs, n + 1),
                        .alpha = view_all<std::uint8_t>(args.alpha),
                        .viewport = args.viewport,
                        .limit = args.limit,
                        .priority = args.priority,
                        .focus = args.focus,
                        .far_limit = args.far_limit},
                       view<Run>(args.runs, count), view_all<float>(args.weights));
}

void ReferenceBackend::intervals(const IntervalsArgs& args) {
    const std::size_t n = args.table.segment_count;
    view<std::uint32_t>(args.total, 1)[0] =
        reference::intervals({.segments = view<Segment>(args.table.segments, n),
                              .vertices = view_all<glm::vec3>(args.table.vertices),
                              .clipped = view<ClippedSegment>(args.clipped.clipped, n),
                              .offsets = view<std::uint32_t>(args.clipped.offsets, n + 1),
                              .arcs = view<std::uint32_t>(args.clipped.arcs, n + 1),
                              .alpha = view_all<std::uint8_t>(args.alpha),
                              .layout = args.layout,
                              .capacity = args.capacity,
                              .viewport = args.viewport,
                              .depth = view_all<float>(args.depth),
                              .depth_size = args.depth_size,
                              .depth_scale = args.depth_scale,
                              .tolerance = args.tolerance,
                              .hidden_too = args.hidden_too},
                             view<Interval>(args.intervals, args.interval_capacity));
}

void ReferenceBackend::compact_samples(const CompactSamplesArgs& args) {
    view<std::uint32_t>(args.packed_count, 1)[0] = reference::compact_samples(
        view<std::uint8_t>(args.alpha, args.count), view<std::uint32_t>(args.packed, args.count));
}

void ReferenceBackend::flush() {}

void ReferenceBackend::finish() {}

std::unique_ptr<Backend> make_reference_backend() {
    return std::make_unique<ReferenceBackend>();
}

} // namespace lineatlas::compute
