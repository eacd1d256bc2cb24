/* pens: which pen draws which run. If a part of a run is outline (outline.cl), the run is divided
 * where that part begins and ends. The pieces stay parts of one stroke.
 *
 * Two steps with a scan between them: count the pieces of each run, then write them in the order of
 * the runs. */

#include "kernels.h"
#include "shared/run.h"

/* In pixels. Parts of outline with less than this between them are one part. Parts shorter than
 * this do not count, unless they are whole segments: within half a pixel of a corner the place
 * beside a line is beside another line. */
#define LEAST_OUTLINE 2.0f

/* The parts of a segment that are outline: `first` up to `last` in a table, in no order. */
typedef struct OutlineParts {
    __global const float* parts;
    uint first, last;
    float unit;  /* samples per pixel; for a segment without samples 1 stands for all of it */
    float whole; /* samples of the segment, or 1 */
} OutlineParts;

/* The next part beyond `after`; false if there is none. */
static bool next_part(const OutlineParts table, const float after, float2* part) {
    const float gap = LEAST_OUTLINE * table.unit;
    float from = INFINITY;
    for (uint k = table.first; k < table.last; ++k) {
        const float2 one = vload2(k, table.parts);
        if (one.y > after) from = fmin(from, fmax(one.x, after));
    }
    if (from == INFINITY) return false;
    float to = from;
    bool grows = true;
    while (grows) {
        grows = false;
        for (uint k = table.first; k < table.last; ++k) {
            const float2 one = vload2(k, table.parts);
            if (one.x > to + gap || one.y <= to) continue;
            to = one.y;
            grows = true;
        }
    }
    *part = float2(from, to);
    return true;
}

/* The next part that counts. A part at an end of the segment goes on with what overshoots that end.
 */
static bool next_outline(const OutlineParts table, float after, float2* part) {
    const float least = LEAST_OUTLINE * table.unit;
    while (next_part(table, after, part)) {
        const bool whole = part->x <= 0.0f && part->y >= table.whole;
        after = part->y;
        if (part->y - part->x < least && !whole) continue;
        if (part->x < least) part->x = -INFINITY;
        if (part->y > table.whole - least) part->y = INFINITY;
        return true;
    }
    return false;
}

/* The pen of a segment, and from bit 16 on its pen where it is outline. */
static uint pens_of(const uint segment, const uint first, __global const uint* segment_pens,
                    __global const uint* origins) {
    if (segment < first) return segment_pens[segment];
    return segment_pens[first + ((origins[segment - first] - 1u) >> 1)];
}

static OutlineParts parts_of(const PensParameters* args, __global const Run* run, const uint pens,
                             __global const uint* part_offsets, __global const float* parts) {
    OutlineParts table = {parts, 0, 0, 0.0f, (float)run->samples};
    if (args->outlines == 0 || (pens & 0xFFFFu) == pens >> 16) return table;
    const float2 way = vload2(0, run->end) - vload2(0, run->start);
    const float length_px = sqrt(way.x * way.x + way.y * way.y);
    if (!(length_px > 0.0f)) return table;
    table.unit = (run->end_sample - run->start_sample) / length_px;
    table.first = part_offsets[run->segment];
    table.last = part_offsets[run->segment + 1];
    return table;
}

/* Flags of a piece of outline. Outlines are the last lines that density control fades, whatever
 * their kind. */
static uint first_in_density(const uint flags) {
    const uint most = (LA_DENSITY_BINS - 1u) * LA_BIN_STEPS;
    return (flags & ~(LA_RUN_BIN_MASK << LA_RUN_BIN_SHIFT)) | most << LA_RUN_BIN_SHIFT;
}

/* A piece of a run, with its flags, from one place to another. */
static void write_piece(__global const Run* run, const uint run_flags, const float from,
                        const float to, const uint pen, __global Run* piece) {
    *piece = *run;
    uint flags = run_flags & ~(LA_RUN_PEN_MASK << LA_RUN_PEN_SHIFT);
    const float scale = 1.0f / (run->end_sample - run->start_sample);
    const float2 start = vload2(0, run->start), way = vload2(0, run->end) - start;
    const float arc = run->end_arc - run->start_arc, deep = run->end_depth - run->start_depth;
    if (from > run->start_sample) {
        const float u = (from - run->start_sample) * scale;
        vstore2(start + way * u, 0, piece->start);
        vstore2(float2(0.0f, 0.0f), 0, piece->start_corner);
        piece->start_arc = run->start_arc + arc * u;
        piece->start_depth = run->start_depth + deep * u;
        piece->start_sample = from;
        flags = (flags & ~(LA_END_MASK << LA_RUN_START_SHIFT)) | LA_END_CLIPPED
                                                                     << LA_RUN_START_SHIFT;
    }
    if (to < run->end_sample) {
        const float u = (to - run->start_sample) * scale;
        vstore2(start + way * u, 0, piece->end);
        vstore2(float2(0.0f, 0.0f), 0, piece->end_corner);
        piece->end_arc = run->start_arc + arc * u;
        piece->end_depth = run->start_depth + deep * u;
        piece->end_sample = to;
        flags = (flags & ~(LA_END_MASK << LA_RUN_END_SHIFT)) | LA_END_CLIPPED << LA_RUN_END_SHIFT;
    }
    piece->flags = flags | pen << LA_RUN_PEN_SHIFT;
}

/* Writes the pieces of a run if there is a table. Returns how many there are. */
static uint divide_run(__global const Run* run, const OutlineParts table, const uint pens,
                       __global Run* out) {
    const uint inner = pens & 0xFFFFu, outline = pens >> 16;
    uint count = 0;
    float at = run->start_sample;
    const float end = run->end_sample;
    float2 part = float2(-INFINITY, -INFINITY);
    while (at < end && next_outline(table, part.y, &part)) {
        const float from = fmax(part.x, at), to = fmin(part.y, end);
        if (!(from < to)) continue;
        if (from > at) {
            if (out != 0) write_piece(run, run->flags, at, from, inner, out + count);
            ++count;
        }
        if (out != 0)
            write_piece(run, first_in_density(run->flags), from, to, outline, out + count);
        ++count;
        at = to;
    }
    if (at < end || count == 0) {
        if (out != 0) write_piece(run, run->flags, at, end, inner, out + count);
        ++count;
    }
    return count;
}

/* counts: pieces of each run. */
KERNEL(pens_count, PensParameters) {
    const uint r = (uint)get_global_id(0);
    if (r >= args.run_capacity) return;
    counts[r] = 0;
    if (r >= record->points[0]) return;
    const uint pens = pens_of(runs[r].segment, args.first, segment_pens, origins);
    counts[r] = divide_run(runs + r, parts_of(&args, runs + r, pens, part_offsets, parts), pens, 0);
}

/* Writes the pieces and their record. If the pieces exceed the table, none is drawn and the host
 * enlarges it. */
KERNEL(pens_write, PensParameters) {
    const uint r = (uint)get_global_id(0);
    const uint total = run_offsets[args.run_capacity];
    if (r == 0) {
        write_record(drawn_record, total, args.drawn_capacity, record->sample_total);
        drawn_record->raw_run_total = record->raw_run_total;
    }
    if (r >= args.run_capacity || r >= record->points[0] || total > args.drawn_capacity) return;
    const uint pens = pens_of(runs[r].segment, args.first, segment_pens, origins);
    divide_run(runs + r, parts_of(&args, runs + r, pens, part_offsets, parts), pens,
               drawn + run_offsets[r]);
}
