/* spans: from the visible parts of segments (visible.cl) to runs, as `compact` makes them of
 * samples, and to intervals, as `intervals` makes them (§4.6). Parts between visible parts are
 * hidden.
 *
 * Positions along a segment go from 0 to 1, as if it had a single sample; the atlas has none. Runs
 * and intervals take two steps each, with a scan between them: count per block of segments, then
 * write. One work-item per block. */

#include "kernels.h"
#include "shared/run.h"

/* The visible parts of all segments. */
typedef struct Spans {
    __global const uint* offsets;
    __global const float* spans;
} Spans;

/* The number of parts of segment i, hidden and visible in turn. Part 2k is the gap before span k,
 * part 2k + 1 the span itself. */
static uint part_numbers(const Spans spans, const uint i) {
    return 2u * (spans.offsets[i + 1] - spans.offsets[i]) + 1u;
}

/* The start and end of part `number`. They are equal for a gap without length. */
static float2 part_of(const Spans spans, const uint i, const uint number) {
    const uint at = spans.offsets[i] + number / 2u;
    if (number % 2u != 0) return vload2(at, spans.spans);
    return float2(number > 0 ? spans.spans[2u * at - 1u] : 0.0f,
                  at < spans.offsets[i + 1] ? spans.spans[2u * at] : 1.0f);
}

/* LA_WANTS_NO_DOTS: see is_dot() in run.h. */
static bool is_wanted(const uint wanted, const float2 part, const uint number) {
    return (wanted & (number % 2u != 0 ? LA_WANTS_VISIBLE : LA_WANTS_HIDDEN)) != 0 &&
           part.x < part.y;
}

static bool has_parts(const SpansParameters* args, __global const Segment* segments,
                      __global const uint* arcs, const uint i) {
    return arcs[i + 1] != arcs[i] &&
           ((args->wanted & LA_WANTS_NO_DOTS) == 0 || !is_dot(segments, arcs, i));
}

/* counts[b]: wanted parts of the segments of block b. */
KERNEL(spans_count, SpansParameters) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * args.block;
    if (first >= args.count) return;
    const uint last = min(first + args.block, args.count);
    const Spans table = {span_offsets, spans};
    uint count = 0;
    if (span_offsets[args.count] <= args.span_capacity) {
        for (uint i = first; i < last; ++i) {
            if (!has_parts(&args, segments, arcs, i)) continue;
            const uint numbers = part_numbers(table, i);
            for (uint n = 0; n < numbers; ++n) {
                if (is_wanted(args.wanted, part_of(table, i, n), n)) ++count;
            }
        }
    }
    counts[b] = count;
}

/* Runs, and their record: see compact_write. */
KERNEL(spans_runs, SpansParameters) {
    const uint b = (uint)get_global_id(0);
    const uint total = block_offsets[args.blocks];
    if (b == 0) write_record(record, total, args.capacity, 0);
    const uint first = b * args.block;
    if (first >= args.count || total > args.capacity || block_offsets[b] == block_offsets[b + 1])
        return;
    const uint last = min(first + args.block, args.count);
    const Frame frame = {segments,       clipped, offsets, arcs, to_float2(args.viewport),
                         args.half_width};
    const Spans table = {span_offsets, spans};
    uint next = block_offsets[b];
    for (uint i = first; i < last; ++i) {
        if (!has_parts(&args, segments, arcs, i)) continue;
        const uint numbers = part_numbers(table, i);
        for (uint n = 0; n < numbers; ++n) {
            const float2 part = part_of(table, i, n);
            if (!is_wanted(args.wanted, part, n)) continue;
            write_run(frame, i, part.x, part.y, 0, 1, LA_RUN_SOLID, runs + next++);
        }
    }
}

/* What an end of a part of segment i is. visible: true if the part is visible. */
static uint end_of_part(const Frame frame, const Spans table, const uint i, const uint at_end,
                        const float place, const bool visible) {
    if (place != (float)at_end) return LA_END_HIDDEN;
    uint neighbour;
    const uint kind = path_end(frame, i, at_end, &neighbour);
    if (kind != LA_END_JOIN) return kind;
    const uint first = table.offsets[neighbour], last = table.offsets[neighbour + 1];
    const bool shown = first < last && (at_end != 0 ? table.spans[2u * first] == 0.0f
                                                    : table.spans[2u * last - 1u] == 1.0f);
    return shown == visible ? kind : LA_END_HIDDEN;
}

/* Intervals, and how many there are: see intervals_write. */
KERNEL(spans_intervals, SpansParameters) {
    const uint b = (uint)get_global_id(0);
    const uint total = block_offsets[args.blocks];
    if (b == 0) *interval_total = total;
    const uint first = b * args.block;
    if (first >= args.count || total > args.capacity || block_offsets[b] == block_offsets[b + 1])
        return;
    const uint last = min(first + args.block, args.count);
    const Frame frame = {segments, clipped, offsets, arcs, to_float2(args.viewport), 0.0f};
    const Spans table = {span_offsets, spans};
    uint next = block_offsets[b];
    for (uint i = first; i < last; ++i) {
        if (!has_parts(&args, segments, arcs, i)) continue;
        const uint numbers = part_numbers(table, i);
        for (uint n = 0; n < numbers; ++n) {
            const float2 part = part_of(table, i, n);
            if (!is_wanted(args.wanted, part, n)) continue;
            const bool visible = n % 2u != 0;
            __global Interval* interval = intervals + next++;
            interval->segment = i;
            interval->alpha = visible ? 1.0f : 0.0f;
            interval->flags =
                LA_INTERVAL_EXACT | (visible ? LA_INTERVAL_VISIBLE : 0u) |
                end_of_part(frame, table, i, 0, part.x, visible) << LA_INTERVAL_START_SHIFT |
                end_of_part(frame, table, i, 1, part.y, visible) << LA_INTERVAL_END_SHIFT;
            place_interval(frame, i, part.x, part.y, 1, vertices, interval);
        }
    }
}
