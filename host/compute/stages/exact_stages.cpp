// The exact method: what is visible of lines by cutting them against faces.
#include <algorithm>

#include "divide_up.hpp"
#include "stages.hpp"

namespace lineatlas::compute {
namespace {

std::uint32_t tiles_of(const ExactParameters& parameters) {
    return static_cast<std::uint32_t>(parameters.tiles.x * parameters.tiles.y);
}

/// A table that is not read where there are no contours.
Buffer& patches_of(const SegmentTable& table) {
    const std::optional<ContourTables>& contours = table.candidates.contours;
    return contours ? *contours->patches : table.triangles;
}

/// A table that is not read where segments are no ways beside others.
Buffer& seen_of(const ExactArgs& args) {
    return args.seen != nullptr ? *args.seen : args.clipped.arcs;
}

/// A table that is not read where there are no batches.
Buffer& states_of(const ExactArgs& args) {
    return args.batches != nullptr ? args.batches->states : args.screen;
}

ExactParameters in_chunks(const ExactArgs& args, const Tuning& tuning) {
    ExactParameters parameters = args.parameters;
    parameters.batched = args.batches != nullptr ? args.batches->count : 0;
    parameters.chunks = tuning.face_chunks;
    parameters.chunk = std::max(divide_up(parameters.triangle_count, tuning.face_chunks), 1U);
    return parameters;
}

} // namespace

void Stages::surfaces(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    launch<kernels::surfaces_vertices>(parameters.vertex_count, tuning_.local_size, parameters,
                                       {.vertices = args.table.vertices, .screen = args.screen});
    device_.clear(args.occluders, tiles_of(parameters) * sizeof(la_uint));
    if (args.batches != nullptr) {
        ExactParameters by_batch = parameters;
        by_batch.count = args.batches->batches();
        launch<kernels::surfaces_occluders>(by_batch.count, tuning_.local_size, by_batch,
                                            {.vertices = args.table.vertices,
                                             .triangles = args.table.triangles,
                                             .screen = args.screen,
                                             .batches = args.batches->boxes,
                                             .occluders = args.occluders});
        surfaces_batches(args, *args.batches, true);
    }
    launch<kernels::surfaces_faces>(parameters.triangle_count, tuning_.local_size, parameters,
                                    {.vertices = args.table.vertices,
                                     .triangles = args.table.triangles,
                                     .screen = args.screen,
                                     .states = states_of(args),
                                     .faces = args.faces,
                                     .planes = args.planes,
                                     .occluders = args.occluders});
}

void Stages::surfaces_boxes(const SegmentTable& table, const BatchTable& batches) {
    launch<kernels::surfaces_boxes>(
        batches.batches(), tuning_.local_size, {batches.count},
        {.vertices = table.vertices, .triangles = table.triangles, .batches = batches.boxes});
}

void Stages::surfaces_batches(const ExactArgs& args, const BatchTable& batches, bool drops_hidden) {
    ExactParameters parameters = args.parameters;
    parameters.count = batches.batches();
    parameters.keeps_hidden = drops_hidden ? 0 : 1;
    launch<kernels::surfaces_batches>(
        parameters.count, tuning_.local_size, parameters,
        {.batches = batches.boxes, .occluders = args.occluders, .states = batches.states});
}

void Stages::tile_lists(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    Buffer& states = states_of(args);
    const std::uint32_t tiles = tiles_of(parameters);
    const std::uint32_t counts = tiles * parameters.chunks;
    device_.clear(args.ends, counts * sizeof(la_uint));
    launch<kernels::tile_lists_count>(parameters.chunks, tuning_.block_local_size, parameters,
                                      {.vertices = args.table.vertices,
                                       .triangles = args.table.triangles,
                                       .screen = args.screen,
                                       .faces = args.faces,
                                       .planes = args.planes,
                                       .occluders = args.occluders,
                                       .states = states,
                                       .counts = args.ends});
    scan(args.ends, counts, ScanKind::saturate);
    launch<kernels::tile_lists_groups>(tiles, tuning_.local_size, parameters,
                                       {.offsets = args.ends, .groups = args.groups});
    scan(args.groups, tiles, ScanKind::saturate);
    launch<kernels::tile_lists_fill>(parameters.chunks, tuning_.block_local_size, parameters,
                                     {.vertices = args.table.vertices,
                                      .triangles = args.table.triangles,
                                      .screen = args.screen,
                                      .faces = args.faces,
                                      .planes = args.planes,
                                      .occluders = args.occluders,
                                      .states = states,
                                      .ends = args.ends,
                                      .entries = args.entries});
    launch<kernels::tile_lists_arrange>(tiles, tuning_.block_local_size, parameters,
                                        {.vertices = args.table.vertices,
                                         .triangles = args.table.triangles,
                                         .screen = args.screen,
                                         .faces = args.faces,
                                         .planes = args.planes,
                                         .ends = args.ends,
                                         .entries = args.entries,
                                         .groups = args.groups,
                                         .blocks = args.blocks,
                                         .boxes = args.boxes});
}

void Stages::visible(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    const std::uint32_t n = parameters.count;
    launch<kernels::visible_count>(n, tuning_.local_size, parameters,
                                   {.segments = args.table.segments,
                                    .seen = seen_of(args),
                                    .clipped = args.clipped.clipped,
                                    .arcs = args.clipped.arcs,
                                    .patches = patches_of(args.table),
                                    .vertices = args.table.vertices,
                                    .triangles = args.table.triangles,
                                    .faces = args.faces,
                                    .planes = args.planes,
                                    .occluders = args.occluders,
                                    .ends = args.ends,
                                    .groups = args.groups,
                                    .blocks = args.blocks,
                                    .boxes = args.boxes,
                                    .counts = args.span_offsets,
                                    .kept = args.kept});
    scan(args.span_offsets, n, ScanKind::saturate);
    visible_write(args);
}

void Stages::visible_write(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    launch<kernels::visible_write>(parameters.count, tuning_.local_size, parameters,
                                   {.segments = args.table.segments,
                                    .seen = seen_of(args),
                                    .clipped = args.clipped.clipped,
                                    .patches = patches_of(args.table),
                                    .vertices = args.table.vertices,
                                    .triangles = args.table.triangles,
                                    .faces = args.faces,
                                    .planes = args.planes,
                                    .occluders = args.occluders,
                                    .ends = args.ends,
                                    .groups = args.groups,
                                    .blocks = args.blocks,
                                    .boxes = args.boxes,
                                    .offsets = args.span_offsets,
                                    .kept = args.kept,
                                    .spans = args.spans});
}

namespace {

OutlineParameters parameters_of(const OutlineArgs& args) {
    constexpr float beside = 0.5F; // pixels
    return {.count = args.count,
            .viewport = args.viewport,
            .reach = beside,
            .depth = args.depth,
            .parallel = args.parallel ? 1U : 0U,
            .capacity = 0,
            .clip_from_world = args.clip_from_world,
            .lift = args.lift};
}

} // namespace

void Stages::outline_seen(const OutlineSeenArgs& args) {
    const std::uint32_t n = args.table.segment_count;
    launch<kernels::outline_seen>(n, tuning_.local_size, {n},
                                  {.segments = args.table.segments,
                                   .arcs = args.clipped.arcs,
                                   .span_offsets = args.spans.offsets,
                                   .numbers = args.numbers});
    scan(args.numbers, n, ScanKind::saturate);
}

void Stages::outline_push(const OutlineArgs& args) {
    launch<kernels::outline_push>(args.count, tuning_.local_size, parameters_of(args),
                                  {.segments = args.table.segments,
                                   .seen = args.seen,
                                   .vertices = args.table.vertices,
                                   .clipped = args.clipped.clipped,
                                   .pushed = args.pushed});
}

void Stages::outline_push_in(const OutlineArgs& args, Buffer& beside_offsets) {
    launch<kernels::outline_push_in>(args.count, tuning_.local_size, parameters_of(args),
                                     {.seen = args.seen,
                                      .clipped = args.clipped.clipped,
                                      .beside_offsets = beside_offsets,
                                      .pushed = args.pushed});
}

void Stages::outline_parts(const OutlinePartsArgs& args) {
    OutlineParameters parameters{};
    parameters.count = args.segment_count;
    parameters.depth = args.depth;
    parameters.capacity = args.part_capacity;
    launch<kernels::outline_parts_count>(args.segment_count, tuning_.local_size, parameters,
                                         {.numbers = args.numbers,
                                          .arcs = args.arcs,
                                          .beside_offsets = args.beside.offsets,
                                          .beside = args.beside.spans,
                                          .within_offsets = args.within.offsets,
                                          .within = args.within.spans,
                                          .counts = args.offsets});
    scan(args.offsets, args.segment_count, ScanKind::saturate);
    launch<kernels::outline_parts_write>(args.segment_count, tuning_.local_size, parameters,
                                         {.numbers = args.numbers,
                                          .arcs = args.arcs,
                                          .beside_offsets = args.beside.offsets,
                                          .beside = args.beside.spans,
                                          .within_offsets = args.within.offsets,
                                          .within = args.within.spans,
                                          .part_offsets = args.offsets,
                                          .parts = args.parts});
}

Buffer& Stages::count_spans(const SegmentTable& table, const ClippedTable& clipped,
                            const SpanTable& spans, const SpansParameters& parameters) {
    Buffer& counts = scratch(block_counts_, parameters.blocks + 1);
    launch<kernels::spans_count>(parameters.blocks, tuning_.block_local_size, parameters,
                                 {.segments = table.segments,
                                  .arcs = clipped.arcs,
                                  .span_offsets = spans.offsets,
                                  .spans = spans.spans,
                                  .counts = counts});
    scan(counts, parameters.blocks, ScanKind::saturate);
    return counts;
}

void Stages::span_runs(const SpanRunsArgs& args) {
    const std::uint32_t n = args.table.segment_count;
    const SpansParameters parameters{.count = n,
                                     .viewport = args.viewport,
                                     .half_width = args.half_width,
                                     .wanted = args.hidden ? LA_WANTS_HIDDEN | LA_WANTS_NO_DOTS
                                                           : LA_WANTS_VISIBLE,
                                     .block = tuning_.segment_block,
                                     .blocks = divide_up(n, tuning_.segment_block),
                                     .span_capacity = args.spans.capacity,
                                     .capacity = args.run_capacity};
    Buffer& counts = count_spans(args.table, args.clipped, args.spans, parameters);
    launch<kernels::spans_runs>(std::max(parameters.blocks, 1U), // the first writes the record
                                tuning_.block_local_size, parameters,
                                {.segments = args.table.segments,
                                 .clipped = args.clipped.clipped,
                                 .offsets = args.clipped.offsets,
                                 .arcs = args.clipped.arcs,
                                 .span_offsets = args.spans.offsets,
                                 .spans = args.spans.spans,
                                 .block_offsets = counts,
                                 .runs = args.runs,
                                 .record = args.record});
}

void Stages::span_intervals(const SpanIntervalsArgs& args) {
    const std::uint32_t n = args.table.segment_count;
    const SpansParameters parameters{.count = n,
                                     .viewport = args.viewport,
                                     .half_width = 0,
                                     .wanted = args.hidden_too ? LA_WANTS_VISIBLE | LA_WANTS_HIDDEN
                                                               : LA_WANTS_VISIBLE,
                                     .block = tuning_.segment_block,
                                     .blocks = divide_up(n, tuning_.segment_block),
                                     .span_capacity = args.spans.capacity,
                                     .capacity = args.interval_capacity};
    Buffer& counts = count_spans(args.table, args.clipped, args.spans, parameters);
    launch<kernels::spans_intervals>(std::max(parameters.blocks, 1U), // the first writes the total
                                     tuning_.block_local_size, parameters,
                                     {.segments = args.table.segments,
                                      .clipped = args.clipped.clipped,
                                      .offsets = args.clipped.offsets,
                                      .arcs = args.clipped.arcs,
                                      .vertices = args.table.vertices,
                                      .span_offsets = args.spans.offsets,
                                      .spans = args.spans.spans,
                                      .block_offsets = counts,
                                      .intervals = args.intervals,
                                      .interval_total = args.total});
}

} // namespace lineatlas::compute
