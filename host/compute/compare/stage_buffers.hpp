#pragma once

#include "compute/backend.hpp"
#include "layouts.hpp"

// Which tables each stage reads and writes, in one place. `mapped(args, map, run)` calls `run` with
// `args` in which every buffer is replaced by what `map` returns for it: map.in(buffer) of one that
// is only read, map.out(name, buffer, layout) of one that is written, perhaps after it was read.
namespace lineatlas::compute {

template <class Map>
SegmentTable mapped_table(const SegmentTable& table, Map& map) {
    return {map.in(table.vertices), map.in(table.triangles), map.in(table.segments),
            table.triangle_count, table.segment_count};
}

template <class Map>
ClippedTable mapped_table(const ClippedTable& table, Map& map) {
    return {map.in(table.clipped), map.in(table.offsets), map.in(table.arcs)};
}

template <class Map, class Run>
void mapped(const TransformArgs& a, Map& map, Run&& run) {
    run(TransformArgs{.rest = map.in(a.rest),
                      .objects = map.in(a.objects),
                      .matrices = map.in(a.matrices),
                      .vertex_count = a.vertex_count,
                      .vertices = map.out("vertices", a.vertices, layouts::number),
                      .drawn = map.out("drawn", a.drawn, layouts::number),
                      .rest_clusters = map.in(a.rest_clusters),
                      .cluster_objects = map.in(a.cluster_objects),
                      .cluster_count = a.cluster_count,
                      .clusters = map.out("clusters", a.clusters, layouts::cluster)});
}

template <class Map, class Run>
void mapped(const BoundsArgs& a, Map& map, Run&& run) {
    run(BoundsArgs{.vertices = map.in(a.vertices),
                   .triangles = map.in(a.triangles),
                   .clusters = map.out("clusters", a.clusters, layouts::cluster),
                   .count = a.count});
}

template <class Map, class Run>
void mapped(const ForgetArgs& a, Map& map, Run&& run) {
    run(ForgetArgs{.segments = map.in(a.segments),
                   .segment_count = a.segment_count,
                   .objects = map.in(a.objects),
                   .jumped = map.in(a.jumped),
                   .ranges = map.out("ranges", a.ranges, layouts::integer)});
}

template <class Map, class Run>
void mapped(const PyramidArgs& a, Map& map, Run&& run) {
    run(PyramidArgs{.depth = map.in(a.depth),
                    .depth_size = a.depth_size,
                    .tiles = map.out("tiles", a.tiles, layouts::number)});
}

template <class Map, class Run>
void mapped(const CullArgs& a, Map& map, Run&& run) {
    run(CullArgs{.clusters = map.in(a.clusters),
                 .count = a.count,
                 .clip_from_world = a.clip_from_world,
                 .depth_size = a.depth_size,
                 .tiles = map.in(a.tiles),
                 .visible = map.out("visible", a.visible, layouts::byte)});
}

template <class Map, class Run>
void mapped(const FacingArgs& a, Map& map, Run&& run) {
    run(FacingArgs{.table = mapped_table(a.table, map),
                   .eye = a.eye,
                   .front = map.out("front", a.front, layouts::byte)});
}

template <class Map, class Run>
void mapped(const ProjectClipArgs& a, Map& map, Run&& run) {
    const OcclusionTest none{a.front, {}, 0, 0, false};
    const OcclusionTest& given = a.occlusion != nullptr ? *a.occlusion : none;
    const OcclusionTest test{map.in(given.tiles), given.tile_count, given.depth_scale,
                             given.tolerance, given.keep_clipped};
    run(ProjectClipArgs{.table = mapped_table(a.table, map),
                        .front = map.in(a.front),
                        .clip_from_world = a.clip_from_world,
                        .world_from_clip = a.world_from_clip,
                        .viewport = a.viewport,
                        .step = a.step,
                        .kind_mask = a.kind_mask,
                        .occlusion = a.occlusion != nullptr ? &test : nullptr,
                        .out = {map.out("clipped", a.out.clipped, layouts::clipped_segment),
                                map.out("offsets", a.out.offsets, layouts::integer),
                                map.out("arcs", a.out.arcs, layouts::integer)}});
}

template <class Map, class Run>
void mapped(const AtlasArgs& a, Map& map, Run&& run) {
    run(AtlasArgs{.clipped = mapped_table(a.clipped, map),
                  .segment_count = a.segment_count,
                  .depth = map.in(a.depth),
                  .depth_size = a.depth_size,
                  .viewport = a.viewport,
                  .depth_scale = a.depth_scale,
                  .probes = a.probes,
                  .tolerance = a.tolerance,
                  .layout = a.layout,
                  .capacity = a.capacity,
                  .alpha = map.out("alpha", a.alpha, layouts::byte),
                  .tile = a.tile});
}

template <class Map, class Run>
void mapped(const TemporalArgs& a, Map& map, Run&& run) {
    run(TemporalArgs{.clipped = mapped_table(a.clipped, map),
                     .segment_count = a.segment_count,
                     .layout = a.layout,
                     .capacity = a.capacity,
                     .alpha = map.out("alpha", a.alpha, layouts::byte),
                     .history = {map.out("history alpha", a.history.alpha, layouts::byte),
                                 map.out("history offsets", a.history.offsets, layouts::integer),
                                 map.out("history ranges", a.history.ranges, layouts::integer)},
                     .use_history = a.use_history});
}

template <class Map, class Run>
void mapped(const CompactRunsArgs& a, Map& map, Run&& run) {
    run(CompactRunsArgs{.table = mapped_table(a.table, map),
                        .clipped = mapped_table(a.clipped, map),
                        .alpha = map.in(a.alpha),
                        .layout = a.layout,
                        .capacity = a.capacity,
                        .viewport = a.viewport,
                        .half_width = a.half_width,
                        .hidden = a.hidden,
                        .runs = map.out("runs", a.runs, layouts::run),
                        .run_capacity = a.run_capacity,
                        .record = map.out("record", a.record, layouts::frame_record)});
}

template <class Map, class Run>
void mapped(const HaloArgs& a, Map& map, Run&& run) {
    run(HaloArgs{.table = mapped_table(a.table, map),
                 .clipped = mapped_table(a.clipped, map),
                 .runs = map.in(a.runs),
                 .record = map.in(a.record),
                 .run_capacity = a.run_capacity,
                 .viewport = a.viewport,
                 .halo = a.halo,
                 .half_width = a.half_width,
                 .tolerance = a.tolerance,
                 .cuts = map.out("cuts", a.cuts, layouts::run_cuts)});
}

template <class Map, class Run>
void mapped(const FilterArgs& a, Map& map, Run&& run) {
    run(FilterArgs{.table = mapped_table(a.table, map),
                   .clipped = mapped_table(a.clipped, map),
                   .alpha = map.out("alpha", a.alpha, layouts::byte),
                   .layout = a.layout,
                   .capacity = a.capacity,
                   .viewport = a.viewport,
                   .half_width = a.half_width,
                   .fill = a.fill,
                   .drop = a.drop,
                   .overshoot = a.overshoot,
                   .overshoot_variation = a.overshoot_variation,
                   .undershoot = a.undershoot,
                   .runs = map.in(a.runs),
                   .record = map.in(a.record),
                   .cuts = a.cuts != nullptr ? &map.in(*a.cuts) : nullptr,
                   .run_capacity = a.run_capacity,
                   .filtered = map.out("filtered", a.filtered, layouts::run),
                   .filtered_capacity = a.filtered_capacity,
                   .filtered_record =
                       map.out("filtered record", a.filtered_record, layouts::frame_record)});
}

template <class Map, class Run>
void mapped(const DensityArgs& a, Map& map, Run&& run) {
    DensityArgs args{.table = mapped_table(a.table, map),
                     .clipped = mapped_table(a.clipped, map),
                     .alpha = map.in(a.alpha),
                     .layout = a.layout,
                     .runs = map.out("runs", a.runs, layouts::run),
                     .record = map.in(a.record),
                     .run_capacity = a.run_capacity,
                     .viewport = a.viewport,
                     .limit = a.limit,
                     .priority = {},
                     .focus = a.focus,
                     .far_limit = a.far_limit,
                     .weights = map.out("weights", a.weights, layouts::number)};
    for (std::size_t kind = 0; kind < LA_KIND_COUNT; ++kind) args.priority[kind] = a.priority[kind];
    run(args);
}

template <class Map, class Run>
void mapped(const IntervalsArgs& a, Map& map, Run&& run) {
    run(IntervalsArgs{.table = mapped_table(a.table, map),
                      .clipped = mapped_table(a.clipped, map),
                      .alpha = map.in(a.alpha),
                      .layout = a.layout,
                      .capacity = a.capacity,
                      .viewport = a.viewport,
                      .depth = map.in(a.depth),
                      .depth_size = a.depth_size,
                      .depth_scale = a.depth_scale,
                      .tolerance = a.tolerance,
                      .hidden_too = a.hidden_too,
                      .intervals = map.out("intervals", a.intervals, layouts::interval),
                      .interval_capacity = a.interval_capacity,
                      .total = map.out("total", a.total, layouts::integer)});
}

template <class Map, class Run>
void mapped(const CompactSamplesArgs& a, Map& map, Run&& run) {
    run(CompactSamplesArgs{.alpha = map.in(a.alpha),
                           .count = a.count,
                           .packed = map.out("packed", a.packed, layouts::integer),
                           .packed_count =
                               map.out("packed count", a.packed_count, layouts::integer)});
}

/// `scan` in the form of the other stages.
struct ScanArgs {
    Buffer& values;
    std::uint32_t n;
    ScanKind kind;
};

template <class Map, class Run>
void mapped(const ScanArgs& a, Map& map, Run&& run) {
    run(ScanArgs{map.out("values", a.values, layouts::integer), a.n, a.kind});
}

} // namespace lineatlas::compute
