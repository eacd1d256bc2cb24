// The exact method: finds visible parts of lines by cutting them against faces.
#include <algorithm>

#include "compute/transfer.hpp"
#include "divide_up.hpp"
#include "stages.hpp"

namespace lineatlas::compute {
namespace {

/// The number of work-items that share the rows of tiles of a triangle, if triangles have
/// work-items of their own. With one, all would wait for a face that covers the picture. Among very
/// many triangles few are large.
std::uint32_t face_slices(std::uint32_t triangles) {
    constexpr std::uint32_t most = 8, most_items = 1U << 22U;
    return std::clamp(most_items / std::max(triangles, 1U), 1U, most);
}

std::uint32_t tiles_of(const ExactParameters& parameters) {
    return static_cast<std::uint32_t>(parameters.tiles.x * parameters.tiles.y);
}

/// Tables that may be missing. Then other tables, which are not read, stand for them.
struct ExactTables {
    Buffer &patches, &seen, &states;
};
ExactTables may_be_absent(const ExactArgs& args) {
    const std::optional<ContourTables>& contours = args.table.candidates.contours;
    return {.patches = contours ? *contours->patches : args.table.triangles,
            .seen = args.seen != nullptr ? *args.seen : args.clipped.arcs,
            .states = args.batches != nullptr ? args.batches->states : args.screen};
}

/// The ranges by which lists are sorted, and the places of their entries.
struct ListRanges {
    Buffer& ranges;
};
struct KeyTables {
    Buffer &keys, &placed;
};

/// The visible parts of segments in each tile, before they are joined.
struct PieceTables {
    Buffer &piece_offsets, &part_offsets, &piece_kept;
};
struct RawParts {
    Buffer& raw_parts;
};

ExactParameters in_chunks(const ExactArgs& args, const Tuning& tuning) {
    ExactParameters parameters = args.parameters;
    parameters.batched = args.batches != nullptr ? args.batches->count : 0;
    parameters.slices = tuning.face_lists ? face_slices(parameters.triangle_count) : 1;
    parameters.chunks = list_columns(tuning);
    parameters.chunk = tuning.face_lists
                           ? 1
                           : std::max(divide_up(parameters.triangle_count, tuning.face_chunks), 1U);
    return parameters;
}

} // namespace

void Stages::surfaces(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    launch<kernels::surfaces_vertices>(parameters.vertex_count, parameters, args.table, args);
    device_.clear(args.occluders, tiles_of(parameters) * sizeof(la_uint));
    if (args.batches != nullptr) {
        ExactParameters by_batch = parameters;
        by_batch.count = args.batches->batches();
        const std::uint32_t items = parameters.slices > 1 ? LA_BATCH * parameters.slices : 1;
        launch<kernels::surfaces_occluders>(by_batch.count * items, by_batch, args.table, args,
                                            BatchBoxes{args.batches->boxes});
        surfaces_batches(args, *args.batches, true);
    }
    launch<kernels::surfaces_faces>(parameters.triangle_count * parameters.slices, parameters,
                                    args.table, args, may_be_absent(args));
}

void Stages::surfaces_batches(const ExactArgs& args, const BatchTable& batches, bool drops_hidden) {
    ExactParameters parameters = args.parameters;
    parameters.count = batches.batches();
    parameters.keeps_hidden = drops_hidden ? 0 : 1;
    launch<kernels::surfaces_batches>(parameters.count, parameters, batches, args,
                                      BatchBoxes{batches.boxes});
}

void Stages::tile_lists(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    const std::uint32_t tiles = tiles_of(parameters);
    const std::uint32_t counts = tiles * parameters.chunks;
    const std::uint32_t chunks =
        divide_up(parameters.triangle_count, parameters.chunk) * parameters.slices;
    device_.clear(args.ends, counts * sizeof(la_uint));
    launch_grouped<kernels::tile_lists_count>(chunks, tuning_.block_local_size, parameters,
                                              args.table, args, may_be_absent(args),
                                              Counts{args.ends});
    scan(args.ends, counts, ScanKind::saturate);
    launch<kernels::tile_lists_groups>(tiles, parameters, args, Offsets{args.ends});
    scan(args.groups, tiles, ScanKind::saturate);
    const std::size_t ranged = tuning_.face_lists ? std::size_t{2} * tiles : 1;
    Buffer& ranges = scratch(Scratch::list_ranges, ranged);
    device_.clear(ranges, ranged * sizeof(la_uint));
    launch_grouped<kernels::tile_lists_fill>(chunks, tuning_.block_local_size, parameters,
                                             args.table, args, may_be_absent(args),
                                             ListRanges{ranges});
    if (tuning_.face_lists) return arrange_by_entries(args, parameters, ranges);
    launch_grouped<kernels::tile_lists_arrange>(tiles, tuning_.block_local_size, parameters,
                                                args.table, args);
}

void Stages::arrange_by_entries(const ExactArgs& args, const ExactParameters& parameters,
                                Buffer& ranges) {
    const std::uint32_t tiles = tiles_of(parameters), entries = parameters.entry_capacity;
    const std::uint32_t keys = tiles * LA_LIST_KEYS;
    const KeyTables lists{scratch(Scratch::list_keys, std::size_t{keys} + 1),
                          scratch(Scratch::list_placed, entries * sizeof(Entry) / sizeof(la_uint))};
    device_.clear(lists.keys, keys * sizeof(la_uint));
    launch<kernels::tile_lists_keys>(entries, parameters, args, lists, ListRanges{ranges});
    scan(lists.keys, keys, ScanKind::saturate);
    launch<kernels::tile_lists_place>(entries, parameters, args, lists);
    launch<kernels::tile_lists_sort>(entries, parameters, args, lists);
    launch<kernels::tile_lists_write>(entries, parameters, args.table, args);
    launch<kernels::tile_lists_boxes>(parameters.group_capacity, parameters, args);
    launch<kernels::tile_lists_behind>(tiles, parameters, args);
}

void Stages::visible(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    const std::uint32_t n = parameters.count;
    if (tuning_.face_lists)
        count_pieces(args, parameters);
    else
        launch<kernels::visible_count>(n, parameters, args.table, args.clipped, args,
                                       may_be_absent(args), Counts{args.span_offsets});
    scan(args.span_offsets, n, ScanKind::saturate);
    visible_write(args);
}

void Stages::count_pieces(const ExactArgs& args, const ExactParameters& parameters) {
    const std::uint32_t n = parameters.count;
    const ExactTables absent = may_be_absent(args);
    Buffer& offsets = scratch(Scratch::piece_offsets, std::size_t{n} + 1);
    launch<kernels::visible_pieces>(n, parameters, args.table, args.clipped, args, absent,
                                    Counts{offsets});
    scan(offsets, n, ScanKind::saturate);
    const auto count = read_one<la_uint>(device_, offsets, n);
    const PieceTables pieces{offsets, scratch(Scratch::piece_parts, std::size_t{count} + 1),
                             scratch(Scratch::piece_kept, std::size_t{4} * count)};
    launch<kernels::visible_cut>(count, parameters, args.table, args.clipped, args, absent, pieces,
                                 Counts{pieces.part_offsets});
    scan(pieces.part_offsets, count, ScanKind::saturate);
    const std::size_t parts = read_one<la_uint>(device_, pieces.part_offsets, count);
    const RawParts raw{scratch(Scratch::raw_parts, 2 * parts)};
    launch<kernels::visible_parts>(count, parameters, args.table, args.clipped, args, absent,
                                   pieces, raw);
    launch<kernels::visible_join>(n, parameters, args.clipped, pieces, raw,
                                  Counts{args.span_offsets});
}

void Stages::visible_write(const ExactArgs& args) {
    const ExactParameters parameters = in_chunks(args, tuning_);
    if (tuning_.face_lists) {
        const PieceTables pieces{scratch_[Scratch::piece_offsets], scratch_[Scratch::piece_parts],
                                 scratch_[Scratch::piece_kept]};
        return launch<kernels::visible_spans>(parameters.count, parameters,
                                              Offsets{args.span_offsets}, args.clipped, pieces,
                                              args, RawParts{scratch_[Scratch::raw_parts]});
    }
    launch<kernels::visible_write>(parameters.count, parameters, Offsets{args.span_offsets},
                                   args.table, args.clipped, args, may_be_absent(args));
}

namespace {

/// The visible parts of the ways beside segments: those on either side, and those on the other
/// side.
struct WayTables {
    Buffer &beside_offsets, &beside, &within_offsets, &within;
};
WayTables ways_of(const OutlinePartsArgs& args) {
    return {args.beside.span_offsets, args.beside.spans, args.within.span_offsets,
            args.within.spans};
}

} // namespace

void Stages::outline_seen(const OutlineSeenArgs& args) {
    const std::uint32_t n = args.table.segment_count;
    launch_each<kernels::outline_seen>(n, args.table, args.clipped, args.spans, args);
    scan(args.numbers, n, ScanKind::saturate);
}

void Stages::outline_parts(const OutlinePartsArgs& args) {
    OutlineParameters parameters{};
    parameters.count = args.segment_count;
    parameters.depth = args.depth;
    parameters.capacity = args.part_capacity;
    launch<kernels::outline_parts_count>(args.segment_count, parameters, args, ways_of(args),
                                         Counts{args.part_offsets});
    scan(args.part_offsets, args.segment_count, ScanKind::saturate);
    launch<kernels::outline_parts_write>(args.segment_count, parameters, args, ways_of(args));
}

Buffer& Stages::count_spans(const SegmentTable& table, const ClippedTable& clipped,
                            const SpanTable& spans, const SpansParameters& parameters) {
    Buffer& counts = scratch(Scratch::block_counts, parameters.blocks + 1);
    launch_grouped<kernels::spans_count>(parameters.blocks, tuning_.block_local_size, parameters,
                                         table, clipped, spans, Counts{counts});
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
    launch_grouped<kernels::spans_runs>(
        std::max(parameters.blocks, 1U), // the first work-item writes the record
        tuning_.block_local_size, parameters, args.table, args.clipped, args.spans, args,
        BlockOffsets{counts});
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
    launch_grouped<kernels::spans_intervals>(
        std::max(parameters.blocks, 1U), // the first work-item writes the total
        tuning_.block_local_size, parameters, args.table, args.clipped, args.spans, args,
        BlockOffsets{counts});
}

} // namespace lineatlas::compute
