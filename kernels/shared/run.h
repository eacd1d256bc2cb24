/* Makes runs of pieces of segments, and finds what their ends are, for `compact`, `halo` and
 * `filter`. */
#ifndef LINEATLAS_RUN_H
#define LINEATLAS_RUN_H

#include "kernels.h"
#include "shared/atlas_samples.h"

/* The tables of a frame. */
typedef struct Frame {
    __global const Segment* segments;
    __global const ClippedSegment* clipped;
    __global const uint* offsets;
    __global const uint* arcs;
    float2 viewport;
    float half_width;
} Frame;

static float2 window_position(__global const float* clip, const float2 viewport) {
    const float4 c = vload4(0, clip);
    return (xy(c) / c.w + 1.0f) * (viewport * 0.5f);
}

static float window_depth(__global const float* clip) {
    return (clip[2] / clip[3] + 1.0f) * 0.5f;
}

/* Unit direction of a clipped segment on the screen; zero for one without length. */
static float2 window_direction(__global const ClippedSegment* segment, const float2 viewport) {
    const float2 d = window_position(segment->q, viewport) - window_position(segment->p, viewport);
    const float length_px = sqrt(d.x * d.x + d.y * d.y);
    return length_px > 0.0f ? d / length_px : float2(0.0f, 0.0f);
}

/* True if segment i and the next one in the table are drawn as one line: they are of one path, and
 * nothing between them was clipped away. */
static bool goes_on(const Frame frame, const uint i) {
    return frame.segments[i].to_end > 0 && frame.clipped[i].t1 >= 1.0f &&
           frame.arcs[i + 2] != frame.arcs[i + 1] && frame.clipped[i + 1].t0 <= 0.0f;
}

/* How the end of a segment meets the neighbour that continues its path (§4.5, mitering). Both
 * strokes have half-width `half_width` and end on the bisector. `own` and `other` are unit
 * directions along the path. `room` is the length of the shorter segment. The corner is where the
 * left edges meet, as seen from the spine for half-width 1: 1/cos of half the turn away. Both
 * segments compute it alike, bit by bit, so that each pixel belongs to one of them. */
static uint join(const float2 own, const float2 other, const float room, const float half_width,
                 float2* corner) {
    const float cosine = own.x * other.x + own.y * other.y;
    if (cosine < LA_JOIN_LIMIT_COSINE) return LA_END_ROUND;
    const float2 sum = own + other;
    const float2 left = float2(-sum.y, sum.x) * (2.0f / (sum.x * sum.x + sum.y * sum.y));
    const float along = left.x * own.x + left.y * own.y;
    if (fabs(along) * half_width > room) return LA_END_ROUND; /* corners would cross */
    *corner = left;
    return LA_END_JOIN;
}

/* What lies at one end of segment i (at_end 0: p', 1: q'): LA_END_CLIPPED, LA_END_PATH, or
 * LA_END_JOIN where the path goes on in segment `neighbour`. */
static uint path_end(const Frame frame, const uint i, const uint at_end, uint* neighbour) {
    const bool clipped = at_end != 0 ? frame.clipped[i].t1 < 1.0f : frame.clipped[i].t0 > 0.0f;
    if (clipped) return LA_END_CLIPPED;
    const uint before = frame.segments[i].from_start;
    const uint after = frame.segments[i].to_end;
    const bool last = at_end != 0 ? after == 0 : before == 0;
    if (last && (frame.segments[i].tag & LA_TAG_CLOSED) == 0) return LA_END_PATH;
    *neighbour = at_end != 0 ? (last ? i - before : i + 1) : (last ? i + after : i - 1);
    /* Arc lengths decide, because a neighbour that is hidden as a whole has no samples. */
    return frame.arcs[*neighbour + 1] != frame.arcs[*neighbour] ? LA_END_JOIN : LA_END_CLIPPED;
}

/* One end of segment i as strokes meet it. */
static uint segment_end(const Frame frame, const uint i, const uint at_end, const float2 direction,
                        float2* corner) {
    *corner = float2(0.0f, 0.0f);
    uint neighbour;
    const uint kind = path_end(frame, i, at_end, &neighbour);
    if (kind != LA_END_JOIN) return kind;
    const uint neighbour_length = frame.arcs[neighbour + 1] - frame.arcs[neighbour];
    const uint own_length = frame.arcs[i + 1] - frame.arcs[i];
    const float room = (float)min(own_length, neighbour_length) * (1.0f / LA_ARC_UNITS_PER_PIXEL);
    const float2 other = window_direction(frame.clipped + neighbour, frame.viewport);
    return join(direction, other, room, frame.half_width, corner);
}

/* True if an end of run r is no end of visibility: the path ends there, or goes on visibly. */
static bool shown_across(__global const Segment* segments, __global const Run* runs,
                         const uint run_count, const uint r, const bool at_end) {
    const uint kind =
        runs[r].flags >> (at_end ? LA_RUN_END_SHIFT : LA_RUN_START_SHIFT) & LA_END_MASK;
    if (kind == LA_END_HIDDEN) return false;
    if (kind != LA_END_JOIN && kind != LA_END_ROUND) return true;
    const uint segment = runs[r].segment;
    const uint before = segments[segment].from_start, after = segments[segment].to_end;
    uint other = r;
    if (at_end) {
        const uint next = after > 0 ? segment + 1u : segment - before;
        if (after > 0)
            ++other;
        else
            while (other > 0 && runs[other - 1u].segment >= next) --other;
        return other < run_count && runs[other].segment == next && runs[other].start_sample == 0.0f;
    }
    const uint previous = before > 0 ? segment - 1u : segment + after;
    if (before > 0) {
        if (r == 0) return false;
        --other;
    } else {
        while (other + 1u < run_count && runs[other + 1u].segment <= previous) ++other;
    }
    return runs[other].segment == previous && runs[other].end_sample == (float)runs[other].samples;
}

static float arc_pixels(const uint units) {
    return (float)units * (1.0f / LA_ARC_UNITS_PER_PIXEL);
}

/* Arc length at the start of segment i: zero is in the middle of its path. */
static float segment_arc(const Frame frame, const uint i) {
    const uint first = i - frame.segments[i].from_start;
    const uint last = i + frame.segments[i].to_end;
    const float half_path = arc_pixels(frame.arcs[last + 1] - frame.arcs[first]) * 0.5f;
    return arc_pixels(frame.arcs[i] - frame.arcs[first]) - half_path;
}

/* A position on a segment. */
typedef struct Place {
    float2 position; /* in the window */
    float depth, arc;
} Place;

/* The place at a position on segment i, counted in its `l` samples. If the segment has no samples,
 * l is the number in which positions are counted. */
static Place place_at(const Frame frame, const uint i, const float sample, const uint l) {
    const float2 p = window_position(frame.clipped[i].p, frame.viewport);
    const float2 q = window_position(frame.clipped[i].q, frame.viewport);
    const float depth_p = window_depth(frame.clipped[i].p);
    const float depth_q = window_depth(frame.clipped[i].q);
    const float u = sample / (float)l;
    Place place;
    /* This is exactly where the next segment starts. */
    place.position = u == 1.0f ? q : p + (q - p) * u;
    place.depth = depth_p + (depth_q - depth_p) * u;
    place.arc = segment_arc(frame, i) + arc_pixels(frame.arcs[i + 1] - frame.arcs[i]) * u;
    return place;
}

/* Fills in the places of a run. The caller fills in flags, corners, stroke and address. */
static void place_run(const Frame frame, const uint i, const float start_sample,
                      const float end_sample, const uint l, __global Run* run) {
    const Place start = place_at(frame, i, start_sample, l);
    const Place end = place_at(frame, i, end_sample, l);
    vstore2(start.position, 0, run->start);
    vstore2(end.position, 0, run->end);
    run->start_arc = start.arc;
    run->end_arc = end.arc;
    run->start_sample = start_sample;
    run->end_sample = end_sample;
    run->start_depth = start.depth;
    run->end_depth = end.depth;
    run->samples = l;
    run->segment = i;
}

/* True if a segment is a path of its own and shorter than a pixel, such as the thickness of a
 * board. Hidden dots are left out: a large model has many of them, and they add nothing to the
 * lines that they touch. Silhouettes do not count as dots, because each is a part of a longer line
 * though it has no path. */
static bool is_dot(__global const Segment* segments, __global const uint* arcs, const uint i) {
    return (segments[i].from_start | segments[i].to_end) == 0 &&
           (segments[i].tag & LA_TAG_KIND_MASK) != LA_KIND_SILHOUETTE &&
           (float)(arcs[i + 1] - arcs[i]) < LA_ARC_UNITS_PER_PIXEL;
}

/* The run of a segment between two positions counted in its l samples. */
static void write_run(const Frame frame, const uint i, const float start_sample,
                      const float end_sample, const uint address, const uint l, const uint flags,
                      __global Run* run) {
    const float2 direction = window_direction(frame.clipped + i, frame.viewport);
    float2 start_corner = float2(0.0f, 0.0f), end_corner = start_corner;
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
                 start_style << LA_STROKE_START_SHIFT | end_style << LA_STROKE_END_SHIFT | flags;
}

/* The point of the model at share u of what the screen shows of segment i. */
static float3 world_point(const Frame frame, const uint i, const float u,
                          __global const float* vertices) {
    const float wp = frame.clipped[i].p[3], wq = frame.clipped[i].q[3];
    const float t0 = frame.clipped[i].t0, t1 = frame.clipped[i].t1;
    const float along = u * wp / ((1.0f - u) * wq + u * wp);
    const float t = t0 + (t1 - t0) * along;
    const float3 p = vload3(frame.segments[i].p, vertices);
    const float3 q = vload3(frame.segments[i].q, vertices);
    return p + (q - p) * t;
}

/* Fills in the places of an interval from `start` to `end`, counted in `l` samples of segment i.
 * The caller fills in the rest. */
static void place_interval(const Frame frame, const uint i, const float start, const float end,
                           const uint l, __global const float* vertices,
                           __global Interval* interval) {
    const Place from = place_at(frame, i, start, l);
    const Place to = place_at(frame, i, end, l);
    interval->start_sample = start;
    interval->end_sample = end;
    vstore2(from.position, 0, interval->start);
    vstore2(to.position, 0, interval->end);
    interval->start_depth = from.depth;
    interval->end_depth = to.depth;
    interval->start_arc = from.arc;
    interval->end_arc = to.arc;
    vstore3(world_point(frame, i, start / (float)l, vertices), 0, interval->start_world);
    vstore3(world_point(frame, i, end / (float)l, vertices), 0, interval->end_world);
}

static void write_record(__global FrameRecord* record, const uint run_total,
                         const uint run_capacity, const uint sample_total) {
    const uint drawn = run_total <= run_capacity ? run_total : 0;
    record->points[0] = drawn;
    record->points[1] = 1;
    record->points[2] = record->points[3] = 0;
    record->sample_total = sample_total;
    record->run_total = run_total;
    record->raw_run_total = run_total;
    record->unused = 0;
}

#endif
