/* compact: from visibility per sample to a packed list of what is visible (§4.6).
 *
 * compact_runs_*: maximal visible runs of every segment, with all that the stroke pass needs to
 * draw them, and the indirect draw record. compact_samples_*: the addresses of all visible samples.
 * Each has two steps with the `scan` stage between them: count per block, then write from the
 * block's offset. One work-item per block of neighbouring segments or samples. */

#include "atlas_address.h"
#include "run.h"
#include "segment_table.h"

#pragma OPENCL FP_CONTRACT OFF

/* Whether a sample belongs in a run: of visible ones, or of hidden ones. */
static bool wanted(const uchar alpha, const uint hidden) {
    return (alpha == 0) == (hidden != 0);
}

/* The end of the run that starts at sample a. */
static uint run_end(__global const uchar* alpha, const uint a, const uint l, const uint hidden) {
    uint end = a + 1;
    while (end < l && wanted(alpha[end], hidden)) ++end;
    return end;
}

/* Whether a segment is a path of its own and shorter than a pixel: the thickness of a board. Hidden
 * ones are left out, of a large model they are many and add nothing to the lines that they touch.
 * An edge of a silhouette is a part of a longer line though it has no path. */
static bool is_dot(__global const Segment* segments, __global const uint* arcs, const uint i) {
    return (segments[i].from_start | segments[i].to_end) == 0 &&
           (segments[i].tag & LA_TAG_KIND_MASK) != LA_KIND_SILHOUETTE &&
           (float)(arcs[i + 1] - arcs[i]) < LA_ARC_UNITS_PER_PIXEL;
}

/* counts[b]: runs in block b of `block` segments, of visible samples or, with hidden 1, of hidden
 * ones; a segment that was dropped as hidden whole is one run then. A segment beyond the atlas has
 * none. */
__kernel void compact_runs_count(__global const Segment* restrict segments,
                                 __global const uint* restrict offsets,
                                 __global const uint* restrict arcs, const uint hidden,
                                 const uint count, __global const uchar* restrict alpha,
                                 const uint width, const uint pitch, const uint capacity,
                                 const uint block, __global uint* restrict counts) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * block;
    if (first >= count) return;
    const uint last = min(first + block, count);
    uint runs = 0;
    for (uint i = first; i < last; ++i) {
        const uint s = offsets[i];
        const uint l = offsets[i + 1] - s;
        if (hidden != 0 && is_dot(segments, arcs, i)) continue;
        if (l == 0 && hidden != 0 && arcs[i + 1] != arcs[i]) ++runs;
        if (l == 0 || l > capacity || s > capacity - l) continue;
        __global const uchar* own = alpha + atlas_address(s, width, pitch);
        for (uint a = 0; a < l; ++a) {
            if (!wanted(own[a], hidden)) continue;
            ++runs;
            a = run_end(own, a, l, hidden);
        }
    }
    counts[b] = runs;
}

/* The run of a segment between two positions counted in its l samples. */
static void write_run(const Frame frame, const uint i, const float start_sample,
                      const float end_sample, const uint address, const uint l, const uint flags,
                      __global Run* run) {
    const float2 direction = window_direction(frame.clipped + i, frame.viewport);
    float2 start_corner = (float2)(0.0f, 0.0f), end_corner = start_corner;
    uint start_style = LA_END_HIDDEN, end_style = LA_END_HIDDEN;
    if (start_sample == 0.0f) start_style = segment_end(frame, i, 0, direction, &start_corner);
    if (end_sample == (float)l) end_style = segment_end(frame, i, 1, direction, &end_corner);
    place_run(frame, i, start_sample, end_sample, l, run);
    vstore2(start_corner, 0, run->start_corner);
    vstore2(end_corner, 0, run->end_corner);
    run->stroke_start = run->start_arc;
    run->stroke_end = run->end_arc;
    run->address = address;
    run->flags = start_style << LA_RUN_START_SHIFT | end_style << LA_RUN_END_SHIFT |
                 start_style << LA_STROKE_START_SHIFT | end_style << LA_STROKE_END_SHIFT |
                 (frame.segments[i].tag & LA_TAG_KIND_MASK) << LA_RUN_KIND_SHIFT | flags;
}

/* Writes the runs of every block from its offset on, and (the first work-item) the frame's record.
 * If the runs exceed the table, none is drawn; the host sees the total, enlarges it and runs the
 * kernel again. */
__kernel void compact_runs_write(
    __global const Segment* restrict segments, __global const ClippedSegment* restrict clipped,
    __global const uint* restrict offsets, __global const uint* restrict arcs, const uint hidden,
    const uint count, __global const uchar* restrict alpha, const uint width, const uint pitch,
    const uint capacity, const float2 viewport, const float half_width, const uint block,
    __global const uint* restrict block_offsets, const uint blocks, const uint run_capacity,
    __global Run* restrict runs, __global FrameRecord* restrict record) {
    const uint b = (uint)get_global_id(0);
    const uint run_total = block_offsets[blocks];
    if (b == 0) write_record(record, run_total, run_capacity, offsets[count]);
    const uint first = b * block;
    if (first >= count || run_total > run_capacity) return;
    const uint last = min(first + block, count);
    const Frame frame = {segments, clipped, offsets, arcs, viewport, half_width};
    uint next = block_offsets[b];
    for (uint i = first; i < last; ++i) {
        const uint s = offsets[i];
        const uint l = offsets[i + 1] - s;
        if (hidden != 0 && is_dot(segments, arcs, i)) continue;
        if (l == 0 && hidden != 0 && arcs[i + 1] != arcs[i]) {
            write_run(frame, i, 0.0f, 1.0f, 0, 1, LA_RUN_SOLID, runs + next++);
        }
        if (l == 0 || l > capacity || s > capacity - l) continue;
        const uint address = atlas_address(s, width, pitch);
        __global const uchar* own = alpha + address;
        for (uint a = 0; a < l; ++a) {
            if (!wanted(own[a], hidden)) continue;
            const uint end = run_end(own, a, l, hidden);
            /* A run fades out half a sample beyond its last one: alpha is interpolated. */
            const float start_sample = a == 0 ? 0.0f : (float)a - 0.5f;
            const float end_sample = end == l ? (float)l : (float)end + 0.5f;
            write_run(frame, i, start_sample, end_sample, address, l, 0, runs + next++);
            a = end;
        }
    }
}

/* counts[b]: visible samples in block b of `block` samples. */
__kernel void compact_samples_count(__global const uchar* restrict alpha, const uint n,
                                    const uint block, __global uint* restrict counts) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * block;
    if (first >= n) return;
    const uint last = n - first < block ? n : first + block;
    uint visible = 0;
    for (uint i = first; i < last; ++i) visible += alpha[i] != 0 ? 1u : 0u;
    counts[b] = visible;
}

/* packed: the addresses of the visible samples, in order. Every address is written and only a
 * visible one kept, since a branch on visibility is often mispredicted; the loop ends with the
 * block's last visible sample, so that nothing is written into the next block's part. */
__kernel void compact_samples_write(__global const uchar* restrict alpha, const uint n,
                                    const uint block, __global const uint* restrict block_offsets,
                                    __global uint* restrict packed) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * block;
    if (first >= n) return;
    uint next = block_offsets[b];
    const uint end = block_offsets[b + 1];
    for (uint i = first; next < end; ++i) {
        packed[next] = i;
        next += alpha[i] != 0 ? 1u : 0u;
    }
}
