/* compact: from the visibility of samples to a packed list of visible runs (§4.6).
 *
 * Writes the maximal visible runs of every segment, with all data that the stroke pass needs, and
 * the indirect draw record. Two steps with the `scan` stage between them: count per block, then
 * write from the block's offset. One work-item per block of neighbouring segments. */

#include "kernels.h"
#include "shared/run.h"

/* True if a sample belongs in a run: of visible samples if hidden is 0, else of hidden samples. */
static bool wanted(const uchar alpha, const uint hidden) {
    return (alpha == 0) == (hidden != 0);
}

/* The end of the run that starts at sample a. */
static uint run_end(__global const uchar* alpha, const uint a, const uint l, const uint hidden) {
    uint end = a + 1;
    while (end < l && wanted(alpha[end], hidden)) ++end;
    return end;
}

/* counts[b]: runs in block b of `block` segments. Runs are of visible samples, or of hidden ones if
 * hidden is 1. If hidden is 1, a segment that was dropped as hidden is one run. A segment beyond
 * the atlas has no runs. */
KERNEL(compact_count, CompactParameters) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * args.block;
    if (first >= args.count) return;
    const uint last = min(first + args.block, args.count);
    uint runs = 0;
    for (uint i = first; i < last; ++i) {
        const uint s = offsets[i];
        const uint l = offsets[i + 1] - s;
        if (args.hidden != 0 && is_dot(segments, arcs, i)) continue;
        if (l == 0 && args.hidden != 0 && arcs[i + 1] != arcs[i]) ++runs;
        if (!is_in_atlas(args.capacity, s, l)) continue;
        __global const uchar* own = alpha + s;
        for (uint a = 0; a < l; ++a) {
            if (!wanted(own[a], args.hidden)) continue;
            ++runs;
            a = run_end(own, a, l, args.hidden);
        }
    }
    counts[b] = runs;
}

/* Writes the runs of every block from its offset on, and (the first work-item) the frame's record.
 * If the runs exceed the table, none is drawn; the host sees the total, enlarges it and runs the
 * kernel again. */
KERNEL(compact_write, CompactParameters) {
    const uint b = (uint)get_global_id(0);
    const uint run_total = block_offsets[args.blocks];
    if (b == 0) write_record(record, run_total, args.run_capacity, offsets[args.count]);
    const uint first = b * args.block;
    if (first >= args.count || run_total > args.run_capacity) return;
    const uint last = min(first + args.block, args.count);
    const Frame frame = {segments,       clipped, offsets, arcs, to_float2(args.viewport),
                         args.half_width};
    uint next = block_offsets[b];
    for (uint i = first; i < last; ++i) {
        const uint s = offsets[i];
        const uint l = offsets[i + 1] - s;
        if (args.hidden != 0 && is_dot(segments, arcs, i)) continue;
        if (l == 0 && args.hidden != 0 && arcs[i + 1] != arcs[i]) {
            write_run(frame, i, 0.0f, 1.0f, 0, 1, LA_RUN_SOLID, runs + next++);
        }
        if (!is_in_atlas(args.capacity, s, l)) continue;
        __global const uchar* own = alpha + s;
        for (uint a = 0; a < l; ++a) {
            if (!wanted(own[a], args.hidden)) continue;
            const uint end = run_end(own, a, l, args.hidden);
            /* A run fades out half a sample beyond its last sample, because alpha is interpolated.
             */
            const float start_sample = a == 0 ? 0.0f : (float)a - 0.5f;
            const float end_sample = end == l ? (float)l : (float)end + 0.5f;
            write_run(frame, i, start_sample, end_sample, s, l, 0, runs + next++);
            a = end;
        }
    }
}
