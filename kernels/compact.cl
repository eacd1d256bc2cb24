/* compact: from visibility per sample to a packed list of what is visible (§4.6).
 *
 * compact_runs_*: maximal visible runs of every segment, with all that the stroke pass needs to
 * draw them, and the indirect draw record. compact_samples_*: the addresses of all visible samples.
 * Each has two steps with the `scan` stage between them: count per block, then write from the
 * block's offset. One work-item per block of neighbouring segments or samples. */

#include "atlas_address.h"
#include "segment_table.h"

#pragma OPENCL FP_CONTRACT OFF

/* The end of the run that starts at sample a. */
static uint run_end(__global const uchar* alpha, const uint a, const uint l) {
    uint end = a + 1;
    while (end < l && alpha[end] != 0) ++end;
    return end;
}

/* counts[b]: visible runs in block b of `block` segments. A segment beyond the atlas has none. */
__kernel void compact_runs_count(__global const uint* restrict offsets, const uint count,
                                 __global const uchar* restrict alpha, const uint width,
                                 const uint pitch, const uint capacity, const uint block,
                                 __global uint* restrict counts) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * block;
    if (first >= count) return;
    const uint last = min(first + block, count);
    uint runs = 0;
    for (uint i = first; i < last; ++i) {
        const uint s = offsets[i];
        const uint l = offsets[i + 1] - s;
        if (l == 0 || l > capacity || s > capacity - l) continue;
        __global const uchar* own = alpha + atlas_address(s, width, pitch);
        for (uint a = 0; a < l; ++a) {
            if (own[a] == 0) continue;
            ++runs;
            a = run_end(own, a, l);
        }
    }
    counts[b] = runs;
}

static float2 window_position(__global const float* clip, const float2 viewport) {
    const float4 c = vload4(0, clip);
    return (c.xy / c.w + 1.0f) * (viewport * 0.5f);
}

/* Unit direction of a clipped segment on the screen; zero for one without length. */
static float2 window_direction(__global const ClippedSegment* segment, const float2 viewport) {
    const float2 d = window_position(segment->q, viewport) - window_position(segment->p, viewport);
    const float length_px = sqrt(d.x * d.x + d.y * d.y);
    return length_px > 0.0f ? d / length_px : (float2)(0.0f, 0.0f);
}

/* How the end of a segment meets the neighbour that continues its path (§4.5, mitering). `own` and
 * `other` are unit directions along the path, `room` is the length of the shorter of the two. The
 * mitre vector leads from the spine to the corner, for half-width 1: 1/cos of half the turn long.
 */
static uint join(const float2 own, const float2 other, const float room, const float half_width,
                 float2* mitre) {
    const float cosine = own.x * other.x + own.y * other.y;
    *mitre = (float2)(-own.y, own.x);
    if (cosine < LA_MITRE_LIMIT_COSINE) return LA_END_ROUND;
    const float2 corner = ((float2)(-own.y, own.x) + (float2)(-other.y, other.x)) / (1.0f + cosine);
    const float along = corner.x * own.x + corner.y * own.y;
    if (fabs(along) * half_width > room) return LA_END_ROUND; /* corners would cross */
    *mitre = corner;
    return LA_END_MITRE;
}

typedef struct Frame {
    __global const Segment* segments;
    __global const ClippedSegment* clipped;
    __global const uint* arcs;
    float2 viewport;
    float half_width;
} Frame;

/* One end of segment i: at_end 0 is p', 1 is q'. */
static uint segment_end(const Frame frame, const uint i, const uint at_end, const float2 direction,
                        float2* mitre) {
    *mitre = (float2)(-direction.y, direction.x);
    const uint tag = frame.segments[i].tag;
    const uint before = frame.segments[i].from_start;
    const uint after = frame.segments[i].to_end;
    const bool clipped = at_end != 0 ? frame.clipped[i].t1 < 1.0f : frame.clipped[i].t0 > 0.0f;
    if (clipped) return LA_END_BUTT;
    const bool last = at_end != 0 ? after == 0 : before == 0;
    if (last && (tag & LA_TAG_CLOSED) == 0) return LA_END_ROUND;
    const uint neighbour = at_end != 0 ? (last ? i - before : i + 1) : (last ? i + after : i - 1);
    /* Arc lengths, not sample counts: a neighbour that is hidden whole has no samples. */
    const uint neighbour_length = frame.arcs[neighbour + 1] - frame.arcs[neighbour];
    if (neighbour_length == 0) return LA_END_ROUND;
    const uint own_length = frame.arcs[i + 1] - frame.arcs[i];
    const float room = (float)min(own_length, neighbour_length) * (1.0f / LA_ARC_UNITS_PER_PIXEL);
    const float2 other = window_direction(frame.clipped + neighbour, frame.viewport);
    return join(direction, other, room, frame.half_width, mitre);
}

/* Writes the runs of every block from its offset on, and (the first work-item) the frame's record.
 * If the runs exceed the table, none is drawn; the host sees the total, enlarges it and runs the
 * kernel again. */
__kernel void compact_runs_write(
    __global const Segment* restrict segments, __global const ClippedSegment* restrict clipped,
    __global const uint* restrict offsets, __global const uint* restrict arcs, const uint count,
    __global const uchar* restrict alpha, const uint width, const uint pitch, const uint capacity,
    const float2 viewport, const float half_width, const uint block,
    __global const uint* restrict block_offsets, const uint blocks, const uint run_capacity,
    __global Run* restrict runs, __global FrameRecord* restrict record) {
    const uint b = (uint)get_global_id(0);
    const uint run_total = block_offsets[blocks];
    if (b == 0) {
        const uint drawn = run_total <= run_capacity ? run_total : 0;
        record->points[0] = drawn;
        record->points[1] = 1;
        record->points[2] = record->points[3] = 0;
        record->quads[0] = 4;
        record->quads[1] = drawn;
        record->quads[2] = record->quads[3] = 0;
        record->sample_total = offsets[count];
        record->run_total = run_total;
        record->unused[0] = record->unused[1] = 0;
    }
    const uint first = b * block;
    if (first >= count || run_total > run_capacity) return;
    const uint last = min(first + block, count);
    const Frame frame = {segments, clipped, arcs, viewport, half_width};
    uint next = block_offsets[b];
    for (uint i = first; i < last; ++i) {
        const uint s = offsets[i];
        const uint l = offsets[i + 1] - s;
        if (l == 0 || l > capacity || s > capacity - l) continue;
        const uint address = atlas_address(s, width, pitch);
        __global const uchar* own = alpha + address;
        for (uint a = 0; a < l; ++a) {
            if (own[a] == 0) continue;
            const uint end = run_end(own, a, l);
            /* A run fades out half a sample beyond its last visible one: alpha is interpolated. */
            const float start_sample = a == 0 ? 0.0f : (float)a - 0.5f;
            const float end_sample = end == l ? (float)l : (float)end + 0.5f;
            const float2 p = window_position(clipped[i].p, viewport);
            const float2 d = window_position(clipped[i].q, viewport) - p;
            const float2 direction = window_direction(clipped + i, viewport);
            float2 start_mitre = (float2)(-direction.y, direction.x);
            float2 end_mitre = start_mitre;
            uint start_style = LA_END_BUTT, end_style = LA_END_BUTT;
            if (a == 0) start_style = segment_end(frame, i, 0, direction, &start_mitre);
            if (end == l) end_style = segment_end(frame, i, 1, direction, &end_mitre);

            const uint path_first = i - segments[i].from_start;
            const uint path_last = i + segments[i].to_end;
            const float per_unit = 1.0f / LA_ARC_UNITS_PER_PIXEL;
            const float half_path =
                (float)(arcs[path_last + 1] - arcs[path_first]) * per_unit * 0.5f;
            const float arc = (float)(arcs[i] - arcs[path_first]) * per_unit - half_path;
            const float length_px = (float)(arcs[i + 1] - arcs[i]) * per_unit;
            const float u0 = start_sample / (float)l;
            const float u1 = end_sample / (float)l;

            __global Run* run = runs + next++;
            vstore2(p + d * u0, 0, run->start);
            vstore2(p + d * u1, 0, run->end);
            vstore2(start_mitre, 0, run->start_mitre);
            vstore2(end_mitre, 0, run->end_mitre);
            run->start_arc = arc + length_px * u0;
            run->end_arc = arc + length_px * u1;
            run->start_sample = start_sample;
            run->end_sample = end_sample;
            run->address = address;
            run->samples = l;
            run->flags = start_style << LA_RUN_START_SHIFT | end_style << LA_RUN_END_SHIFT |
                         (segments[i].tag & LA_TAG_KIND_MASK) << LA_RUN_KIND_SHIFT;
            run->segment = i;
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
