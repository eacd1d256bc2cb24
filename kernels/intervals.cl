/* intervals: the visible and the hidden parts of every segment, for the readback (§4.6), with ends
 * between the samples.
 *
 * Three steps: count the intervals of every block of segments (and scan the counts), write them
 * with their ends where neighbouring samples differ, narrow every end down against the depth
 * buffer. If two neighbouring segments of a path differ, visibility may change on either side of
 * their joint. So each segment gets an interval for its half sample at the joint, of no length if
 * the change is on the other side.
 *
 * PROBE_VECTORS: as in atlas.cl. */

#define PROBES 9
#if PROBE_VECTORS
#define LANES 16
#define LANES_IN_USE PROBES
#else
#define LANES 1
#endif

#include "kernels.h"
#include "shared/probe.h"
#include "shared/run.h"

/* The atlas, and which intervals are wanted: bit 0 visible ones, bit 1 hidden ones. */
typedef struct Atlas {
    __global const uchar* alpha;
    uint capacity;
    uint wanted;
} Atlas;

/* A part of a segment: from one change of visibility to the next, counted in samples. */
typedef struct Piece {
    float start, end;
    uint start_change, end_change;
    bool visible;
} Piece;

/* The samples of segment i; null if it has no samples or they are beyond the atlas. */
static __global const uchar* samples_of(const Frame frame, const Atlas atlas, const uint i) {
    const uint s = frame.offsets[i];
    const uint l = frame.offsets[i + 1] - s;
    return is_in_atlas(atlas.capacity, s, l) ? atlas.alpha + s : 0;
}

/* Visibility (of 255) from which on segment i counts as visible. */
static uint least_shown(const Frame frame, const uint i) {
    return LA_INTERVAL_SHOWN(frame.segments[i].tag & LA_TAG_KIND_MASK);
}

/* Whether the path is visible just beyond one end of segment i; `own` where it ends there. */
static bool shown_beyond(const Frame frame, const Atlas atlas, const uint i, const uint at_end,
                         const uint least, const bool own) {
    uint neighbour;
    if (path_end(frame, i, at_end, &neighbour) != LA_END_JOIN) return own;
    __global const uchar* samples = samples_of(frame, atlas, neighbour);
    if (samples == 0) return false;
    const uint last = frame.offsets[neighbour + 1] - frame.offsets[neighbour] - 1u;
    return samples[at_end != 0 ? 0u : last] >= least;
}

/* Mean visibility of the samples whose middles lie in the piece. */
static float mean_alpha(__global const uchar* samples, const Piece piece) {
    const uint first = (uint)(piece.start + 0.5f), end = (uint)(piece.end + 0.5f);
    if (first >= end) return piece.visible ? 1.0f : 0.0f;
    uint sum = 0;
    for (uint j = first; j < end; ++j) sum += samples[j];
    return (float)sum / (255.0f * (float)(end - first));
}

static uint end_kind(const Frame frame, const uint i, const uint at_end, const uint change) {
    uint neighbour;
    return change == LA_CHANGE_NONE ? path_end(frame, i, at_end, &neighbour) : LA_END_HIDDEN;
}

/* Adds a piece of segment i if pieces of its visibility are wanted. out null: counts only. */
static uint put(const Frame frame, const Atlas atlas, const uint i, __global const uchar* samples,
                const Piece piece, const uint count, __global Interval* out) {
    if ((atlas.wanted & (piece.visible ? 1u : 2u)) == 0) return count;
    if (out != 0) {
        out[count].segment = i;
        out[count].start_sample = piece.start;
        out[count].end_sample = piece.end;
        out[count].alpha = samples != 0 ? mean_alpha(samples, piece) : 0.0f;
        out[count].flags = (piece.visible ? LA_INTERVAL_VISIBLE : 0u) |
                           end_kind(frame, i, 0, piece.start_change) << LA_INTERVAL_START_SHIFT |
                           end_kind(frame, i, 1, piece.end_change) << LA_INTERVAL_END_SHIFT |
                           piece.start_change << LA_INTERVAL_START_CHANGE_SHIFT |
                           piece.end_change << LA_INTERVAL_END_CHANGE_SHIFT;
    }
    return count + 1u;
}

/* The intervals of segment i; returns how many. */
static uint put_segment(const Frame frame, const Atlas atlas, const uint i,
                        __global Interval* out) {
    if (frame.arcs[i + 1] == frame.arcs[i]) return 0; /* the segment is not in this frame */
    __global const uchar* samples = samples_of(frame, atlas, i);
    Piece piece = {0.0f, 1.0f, LA_CHANGE_NONE, LA_CHANGE_NONE, false};
    if (samples == 0) return put(frame, atlas, i, samples, piece, 0, out);
    const uint l = frame.offsets[i + 1] - frame.offsets[i];
    const uint least = least_shown(frame, i);
    uint count = 0;
    bool shown = samples[0] >= least;
    if (shown_beyond(frame, atlas, i, 0, least, shown) != shown) {
        piece.end = 0.25f;
        piece.end_change = LA_CHANGE_HEAD;
        piece.visible = !shown;
        count = put(frame, atlas, i, samples, piece, count, out);
        piece.start = piece.end;
        piece.start_change = piece.end_change;
    }
    for (uint j = 1; j < l; ++j) {
        if ((samples[j] >= least) == shown) continue;
        piece.end = (float)j;
        piece.end_change = LA_CHANGE_WITHIN;
        piece.visible = shown;
        count = put(frame, atlas, i, samples, piece, count, out);
        piece.start = piece.end;
        piece.start_change = piece.end_change;
        shown = !shown;
    }
    piece.visible = shown;
    if (shown_beyond(frame, atlas, i, 1, least, shown) != shown) {
        piece.end = (float)l - 0.25f;
        piece.end_change = LA_CHANGE_TAIL;
        count = put(frame, atlas, i, samples, piece, count, out);
        piece.start = piece.end;
        piece.start_change = piece.end_change;
        piece.visible = !shown;
    }
    piece.end = (float)l;
    piece.end_change = LA_CHANGE_NONE;
    return put(frame, atlas, i, samples, piece, count, out);
}

/* counts[b]: intervals in block b of `block` segments. */
KERNEL(intervals_count, IntervalsParameters) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * args.block;
    if (first >= args.count) return;
    const uint last = min(first + args.block, args.count);
    const Frame frame = {segments, clipped, offsets, arcs, to_float2(args.viewport), 0.0f};
    const Atlas atlas = {alpha, args.capacity, args.wanted};
    uint total = 0;
    for (uint i = first; i < last; ++i) total += put_segment(frame, atlas, i, 0);
    counts[b] = total;
}

/* Writes the intervals of every block from its offset on, without their places. If the intervals
 * exceed the table, none is written, and the host sees the total. */
KERNEL(intervals_write, IntervalsParameters) {
    const uint b = (uint)get_global_id(0);
    const uint total = block_offsets[args.blocks];
    if (b == 0) *interval_total = total;
    const uint first = b * args.block;
    if (first >= args.count || total > args.interval_capacity) return;
    const uint last = min(first + args.block, args.count);
    const Frame frame = {segments, clipped, offsets, arcs, to_float2(args.viewport), 0.0f};
    const Atlas atlas = {alpha, args.capacity, args.wanted};
    uint next = block_offsets[b];
    for (uint i = first; i < last; ++i) next += put_segment(frame, atlas, i, intervals + next);
}

/* A segment along which a change of visibility is looked for. */
typedef struct Line {
    Spine spine;
    float l; /* samples */
    float inverse_l;
    float pixel; /* length of a pixel in samples */
    uint least;  /* visibility (of 255) from which on it counts as visible */
} Line;

/* True if the line is visible at a position counted in samples. The probes are those in a box one
 * pixel wide and long, so that a slanted edge of depth texels counts as the straight edge that it
 * stands for. */
static bool shown_at(const Line line, const float sample, const Depth depth) {
    uint visible = 0;
    for (int first = 0; first < PROBES; first += LANES) {
        const lanes_int probe = LANE_INDEX + first;
        const lanes_int row = probe / 3;
        const lanes_int column = probe - row * 3;
        const lanes_float across = TO_FLOAT(column) - 1.0f, ahead = TO_FLOAT(row) - 1.0f;
        const lanes_float side = across * (1.0f / 3.0f) + ahead * (1.0f / 9.0f);
        const lanes_float along = ahead * (1.0f / 3.0f) + across * (1.0f / 9.0f);
        const lanes_float u = (sample + along * line.pixel) * line.inverse_l;
        visible += (uint)COUNT(sees_line(line.spine, u, side, probe < PROBES, depth));
    }
    return 255u * visible >= line.least * PROBES;
}

/* Where visibility changes. shown: visible before the change. */
static float narrow(const Line line, const uint change, const float around, const bool shown,
                    const Depth depth) {
    if (change == LA_CHANGE_NONE) return around;
    float low = around - 0.5f, high = around + 0.5f;
    if (change == LA_CHANGE_HEAD) {
        if (shown_at(line, 0.0f, depth) != shown) return 0.0f;
        low = 0.0f;
        high = 0.5f;
    } else if (change == LA_CHANGE_TAIL) {
        if (shown_at(line, line.l, depth) == shown) return line.l;
        low = line.l - 0.5f;
        high = line.l;
    }
    for (int step = 0; step < LA_INTERVAL_STEPS; ++step) {
        const float middle = 0.5f * (low + high);
        if (shown_at(line, middle, depth) == shown)
            low = middle;
        else
            high = middle;
    }
    return 0.5f * (low + high);
}

/* Puts the ends of every interval where they belong. */
KERNEL(intervals_refine, IntervalsParameters) {
    const uint k = (uint)get_global_id(0);
    if (*interval_total > args.interval_capacity || k >= *interval_total) return;
    __global Interval* interval = intervals + k;
    const uint i = interval->segment;
    const Frame frame = {segments, clipped, offsets, arcs, to_float2(args.viewport), 0.0f};
    const Depth seen =
        make_depth(depth, to_int2(args.depth_size), int2(0, 0), frame.viewport, args.depth_scale,
                   args.tolerance, args.surfaces, numbers, planes, patches);
    const uint l = max(offsets[i + 1] - offsets[i], 1u);
    const Line line = {spine_of(clipped + i, frame.viewport, seen), (float)l, 1.0f / (float)l,
                       (float)l / arc_pixels(arcs[i + 1] - arcs[i]), least_shown(frame, i)};
    const bool visible = (interval->flags & LA_INTERVAL_VISIBLE) != 0;
    const uint start_change = interval->flags >> LA_INTERVAL_START_CHANGE_SHIFT & LA_CHANGE_MASK;
    const uint end_change = interval->flags >> LA_INTERVAL_END_CHANGE_SHIFT & LA_CHANGE_MASK;
    const float start = narrow(line, start_change, interval->start_sample, !visible, seen);
    const float end = narrow(line, end_change, interval->end_sample, visible, seen);

    place_interval(frame, i, start, end, l, vertices, interval);
}
