// The exact method: finds visible parts of lines by cutting them against faces.
#include <algorithm>

#include "compute/transfer.hpp"
#include "exact_visibility.hpp"

namespace lineatlas::compute {
namespace {

/// The number of work-items that share the rows of tiles of a triangle, if triangles have
/// work-items of their own. With one, all would wait for a face that covers the picture. Among very
/// many triangles few are large.
std::uint32_t face_slices(std::uint32_t triangles) {
    constexpr std::uint32_t most = 8, most_items = 1U << 22U;
    return std::clamp(most_items / std::max(triangles, 1U), 1U, most);
}

} // namespace

ExactVisibility::Optional ExactVisibility::optional() const {
    const std::optional<ContourTables>& contours = table_->candidates.contours;
    return {contours ? contours->patches : nullptr, batches_.states};
}

ExactParameters ExactVisibility::in_chunks(const ExactParameters& own) const {
    const Tuning& tuning = device_.tuning();
    ExactParameters parameters = own;
    parameters.batched = batches_.count;
    parameters.slices = tuning.face_lists ? face_slices(parameters.triangle_count) : 1;
    parameters.chunks = columns();
    parameters.chunk = tuning.face_lists
                           ? 1
                           : std::max(divide_up(parameters.triangle_count, tuning.face_chunks), 1U);
    return parameters;
}

void ExactVisibility::surfaces() {
    batches_ = triangles_.has_triangles(*table_) ? triangles_.table() : BatchTable{};
    const ExactParameters parameters = in_chunks(parameters_);
    stages_.launch<kernels::surfaces_vertices>(parameters.vertex_count, parameters, *table_,
                                               lists_);
    device_.clear(*lists_.occluders, tiles() * sizeof(la_uint));
    if (batches_.count > 0) {
        ExactParameters by_batch = parameters;
        by_batch.count = batches_.batch_count();
        const std::uint32_t items = parameters.slices > 1 ? LA_BATCH * parameters.slices : 1;
        stages_.launch<kernels::surfaces_occluders>(by_batch.count * items, by_batch, *table_,
                                                    lists_, batches_);
        find_batches(batches_, true);
    }
    stages_.launch<kernels::surfaces_faces>(parameters.triangle_count * parameters.slices,
                                            parameters, *table_, lists_, optional());
}

void ExactVisibility::find_batches(const BatchTable& batches, bool drops_hidden) {
    ExactParameters parameters = parameters_;
    parameters.count = batches.batch_count();
    parameters.keeps_hidden = drops_hidden ? 0 : 1;
    stages_.launch<kernels::surfaces_batches>(parameters.count, parameters, batches, lists_);
}

void ExactVisibility::tile_lists() {
    const Tuning& tuning = device_.tuning();
    const ExactParameters parameters = in_chunks(parameters_);
    const std::uint32_t counts = tiles() * parameters.chunks;
    const std::uint32_t chunks =
        divide_up(parameters.triangle_count, parameters.chunk) * parameters.slices;
    device_.clear(*lists_.ends, counts * sizeof(la_uint));
    stages_.launch_grouped<kernels::tile_lists_count>(chunks, tuning.block_local_size, parameters,
                                                      {.counts = lists_.ends.get()}, *table_,
                                                      lists_, optional());
    stages_.scan(*lists_.ends, counts, ScanKind::saturate);
    stages_.launch<kernels::tile_lists_groups>(tiles(), parameters, {.offsets = lists_.ends.get()},
                                               lists_);
    stages_.scan(*lists_.groups, tiles(), ScanKind::saturate);
    const std::size_t ranged = tuning.face_lists ? std::size_t{2} * tiles() : 1;
    Buffer& ranges = stages_.exact_scratch().ranges.with_room(ranged);
    device_.clear(ranges, ranged * sizeof(la_uint));
    stages_.launch_grouped<kernels::tile_lists_fill>(chunks, tuning.block_local_size, parameters,
                                                     {.ranges = &ranges}, *table_, lists_,
                                                     optional());
    if (tuning.face_lists) return arrange_by_entries(parameters);
    stages_.launch_grouped<kernels::tile_lists_arrange>(tiles(), tuning.block_local_size,
                                                        parameters, *table_, lists_);
}

void ExactVisibility::arrange_by_entries(const ExactParameters& parameters) {
    const std::uint32_t entries = parameters.entry_capacity;
    const std::uint32_t keys = tiles() * LA_LIST_KEYS;
    Stages::ExactScratch& scratch = stages_.exact_scratch();
    scratch.keys.with_room(std::size_t{keys} + 1);
    scratch.placed.with_room(entries * sizeof(Entry) / sizeof(la_uint));
    device_.clear(*scratch.keys, keys * sizeof(la_uint));
    stages_.launch<kernels::tile_lists_keys>(entries, parameters, lists_, scratch);
    stages_.scan(*scratch.keys, keys, ScanKind::saturate);
    stages_.launch<kernels::tile_lists_place>(entries, parameters, lists_, scratch);
    stages_.launch<kernels::tile_lists_sort>(entries, parameters, lists_, scratch);
    stages_.launch<kernels::tile_lists_write>(entries, parameters, *table_, lists_);
    stages_.launch<kernels::tile_lists_boxes>(parameters.group_capacity, parameters, lists_);
    stages_.launch<kernels::tile_lists_behind>(tiles(), parameters, lists_);
}

void ExactVisibility::visible(const ClippedTable& clipped) {
    find_spans(lines(clipped));
}

void ExactVisibility::find_spans(const Lines& lines) {
    const ExactParameters parameters = in_chunks(lines.parameters);
    const std::uint32_t n = parameters.count;
    Buffer& offsets = *lines.found.offsets;
    if (device_.tuning().face_lists)
        count_pieces(lines, parameters);
    else
        stages_.launch<kernels::visible_count>(n, parameters, {.counts = &offsets}, *table_, lines,
                                               lines.clipped, lists_, optional(), lines.found);
    stages_.scan(offsets, n, ScanKind::saturate);
    write_spans(lines);
}

void ExactVisibility::count_pieces(const Lines& lines, const ExactParameters& parameters) {
    const std::uint32_t n = parameters.count;
    Stages::ExactScratch& scratch = stages_.exact_scratch();
    Buffer& offsets = scratch.piece_offsets.with_room(std::size_t{n} + 1);
    stages_.launch<kernels::visible_pieces>(n, parameters, {.counts = &offsets}, *table_, lines,
                                            lines.clipped, lists_, optional());
    stages_.scan(offsets, n, ScanKind::saturate);
    const auto count = read_one<la_uint>(device_, offsets, n);
    Buffer& part_offsets = scratch.part_offsets.with_room(std::size_t{count} + 1);
    scratch.piece_kept.with_room(std::size_t{4} * count);
    stages_.launch<kernels::visible_cut>(count, parameters, {.counts = &part_offsets}, *table_,
                                         lines, lines.clipped, lists_, optional(), scratch);
    stages_.scan(part_offsets, count, ScanKind::saturate);
    scratch.raw_parts.with_room(2 * std::size_t{read_one<la_uint>(device_, part_offsets, count)});
    stages_.launch<kernels::visible_parts>(count, parameters, *table_, lines, lines.clipped, lists_,
                                           optional(), scratch);
    stages_.launch<kernels::visible_join>(n, parameters, {.counts = lines.found.offsets.get()},
                                          lines.clipped, scratch);
}

void ExactVisibility::write_spans(const Lines& lines) {
    ExactParameters parameters = in_chunks(lines.parameters);
    parameters.span_capacity = lines.found.capacity;
    if (device_.tuning().face_lists) {
        return stages_.launch<kernels::visible_spans>(parameters.count, parameters, lines.found,
                                                      lines.clipped, stages_.exact_scratch());
    }
    stages_.launch<kernels::visible_write>(parameters.count, parameters, lines.found, *table_,
                                           lines, lines.clipped, lists_, optional());
}

void Stages::outline_seen(const SegmentTable& table, const ClippedTable& clipped,
                          const SpanTable& spans, Buffer& numbers) {
    const std::uint32_t n = table.segment_count;
    launch<kernels::outline_seen>(n, {n}, {.numbers = &numbers}, table, clipped, spans);
    scan(numbers, n, ScanKind::saturate);
}

void Stages::outline_parts(const OutlinePartsArgs& args) {
    OutlineParameters parameters{};
    parameters.count = args.segment_count;
    parameters.depth = args.depth;
    parameters.capacity = args.part_capacity;
    const struct {
        Buffer &beside_offsets, &beside, &within_offsets, &within;
    } ways{args.beside.span_offsets, args.beside.spans, args.within.span_offsets,
           args.within.spans};
    launch<kernels::outline_parts_count>(args.segment_count, parameters,
                                         {.counts = &args.part_offsets}, args, ways);
    scan(args.part_offsets, args.segment_count, ScanKind::saturate);
    launch<kernels::outline_parts_write>(args.segment_count, parameters, args, ways);
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
                                     .capacity = args.runs.capacity};
    write_blocks<kernels::spans_count, kernels::spans_runs>(parameters, args.table, args.clipped,
                                                            args.spans, args.runs);
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
                                     .capacity = args.into.capacity};
    write_blocks<kernels::spans_count, kernels::spans_intervals>(
        parameters, args.table, args.clipped, args.spans, args.into);
}

} // namespace lineatlas::compute
