/* Looking at the depth buffer along a segment: what `atlas` and `intervals` share. OpenCL C only.
 *
 * PROBE_LANES: how many probes are made at once, in the lanes of a vector: 1, 4 or 16. PROBES: how
 * many of 16 lanes are in use. */
#ifndef LINEATLAS_PROBE_H
#define LINEATLAS_PROBE_H

#include "segment_table.h"

/* Lanes of probes. A comparison of vectors gives -1 for true, of scalars 1; `& 1` serves both. */
#if PROBE_LANES == 1
typedef float lanes_float;
typedef int lanes_int;
#define LANE_INDEX 0
#define TO_FLOAT(x) ((float)(x))
#define FLOOR_TO_INT(x) convert_int_rtn(x)
#define LOAD_LANES(from, i) ((from)[i])
#define ANY(mask) ((mask) != 0)
#define COUNT(mask) ((mask)&1)
#elif PROBE_LANES == 4
typedef float4 lanes_float;
typedef int4 lanes_int;
#define LANE_INDEX (int4)(0, 1, 2, 3)
#define TO_FLOAT(x) convert_float4(x)
#define FLOOR_TO_INT(x) convert_int4_rtn(x)
#define LOAD_LANES(from, i) (float4)((from)[i.x], (from)[i.y], (from)[i.z], (from)[i.w])
#define ANY(mask) any(mask)
static int count_lanes(const int4 mask) {
    const int4 ones = mask & 1;
    return ones.x + ones.y + ones.z + ones.w;
}
#define COUNT(mask) count_lanes(mask)
#elif PROBE_LANES == 16
typedef float16 lanes_float;
typedef int16 lanes_int;
#define LANE_INDEX (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15)
#define TO_FLOAT(x) convert_float16(x)
#define FLOOR_TO_INT(x) convert_int16_rtn(x)
#if PROBES == 9
#define LOAD_LANES(from, i)                                                                        \
    (float16)((from)[i.s0], (from)[i.s1], (from)[i.s2], (from)[i.s3], (from)[i.s4], (from)[i.s5],  \
              (from)[i.s6], (from)[i.s7], (from)[i.s8], 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f)
#else
#define LOAD_LANES(from, i)                                                                        \
    (float16)((from)[i.s0], (from)[i.s1], (from)[i.s2], (from)[i.s3], (from)[i.s4], (from)[i.s5],  \
              (from)[i.s6], (from)[i.s7], (from)[i.s8], (from)[i.s9], (from)[i.sa], (from)[i.sb],  \
              (from)[i.sc], (from)[i.sd], (from)[i.se], (from)[i.sf])
#endif
#define ANY(mask) any(mask)
static int count_lanes(const int16 mask) {
    const int16 ones = mask & 1;
    const int8 eight = ones.lo + ones.hi;
    const int4 four = eight.lo + eight.hi;
    return four.x + four.y + four.z + four.w;
}
#define COUNT(mask) count_lanes(mask)
#else
#error "PROBE_LANES must be 1, 4 or 16"
#endif

/* One of the two faces of a line, as own_face in project_clip.cl describes it. */
typedef struct OwnFace {
    float slope;  /* window depth per pixel across the line, to the left */
    float height; /* of the third corner above the line, pixels, positive to the left; 0: no face */
} OwnFace;

static OwnFace unpack_own_face(const uint packed) {
    const OwnFace face = {as_float(packed << 16), as_float(packed & 0xFFFF0000u)};
    return face;
}

/* A segment on the screen, ready for its samples. Texels are those of the depth buffer. */
typedef struct Spine {
    float2 p, d;                    /* p' in texels, and the way to q' */
    float depth_p, depth_d;         /* window depth, linear on the screen */
    float inverse_w_p, inverse_w_d; /* so is 1/w */
    float2 along;                   /* unit vector along the segment */
    float depth_along;              /* window depth per pixel along it */
    OwnFace a, b;
    float outside; /* of a fold, both faces on one side (a silhouette): 1 left, -1 right; else 0 */
    float inverse_l; /* 1 / sample count */
} Spine;

static Spine make_spine(__global const ClippedSegment* segment, const float2 viewport,
                        const float depth_scale, const uint l) {
    const float4 p = vload4(0, segment->p);
    const float4 q = vload4(0, segment->q);
    const float3 scale = (float3)(viewport * 0.5f, 0.5f);
    const float3 window_p = (p.xyz / p.w + 1.0f) * scale;
    const float3 window_q = (q.xyz / q.w + 1.0f) * scale;
    const float3 d = window_q - window_p;
    const float length_px = sqrt(d.x * d.x + d.y * d.y);
    const bool has_length = length_px > 0.0f;
    Spine spine;
    spine.p = window_p.xy * depth_scale;
    spine.d = d.xy * depth_scale;
    spine.depth_p = window_p.z;
    spine.depth_d = d.z;
    spine.inverse_w_p = 1.0f / p.w;
    spine.inverse_w_d = 1.0f / q.w - 1.0f / p.w;
    spine.along = has_length ? d.xy / length_px : (float2)(1.0f, 0.0f);
    spine.depth_along = has_length ? d.z / length_px : 0.0f;
    spine.a = unpack_own_face(segment->own_a);
    spine.b = unpack_own_face(segment->own_b);
    const bool both_left = spine.a.height > 0.0f && spine.b.height > 0.0f;
    const bool both_right = spine.a.height < 0.0f && spine.b.height < 0.0f;
    spine.outside = both_left ? -1.0f : both_right ? 1.0f : 0.0f;
    spine.inverse_l = 1.0f / (float)l;
    return spine;
}

/* Which probes see the line's own face. seen: depth less the line's depth beside it; across: pixels
 * to the left of the line; before: the tolerance there, in window depth. */
static lanes_int is_own_face(const OwnFace face, const lanes_float seen, const lanes_float across,
                             const lanes_float before) {
    const float sign = face.height > 0.0f ? 1.0f : -1.0f;
    const float reach = fabs(face.height) + LA_OWN_FACE_SNAP;
    const float snap = fabs(face.slope) * LA_OWN_FACE_SNAP + LA_DEPTH_ROUNDING;
    const lanes_float expected = face.slope * across;
    const lanes_int on_side = across * sign > -LA_OWN_FACE_SNAP;
    const lanes_int in_reach =
        fabs(across) <= reach || fabs(expected) <= LA_OWN_FACE_REACH * before;
    return on_side && in_reach && fabs(seen - expected) <= fmin(snap, before);
}

/* The depth buffer, and how much may stand before a line: in window depth times w. */
typedef struct Depth {
    __global const float* texels;
    int2 size;
    float scale; /* texels per pixel */
    float tolerance;
} Depth;

/* Which probes see the line: those at `side` pixels to the left of the point at share u of the
 * segment, where nothing in the depth buffer stands before it by more than the tolerance, or where
 * what stands there is one of the line's own two faces: their planes are known, so they need no
 * bias. Only lanes in `in_use` are of interest. */
static lanes_int sees_line(const Spine spine, const lanes_float u, const lanes_float side,
                           const lanes_int in_use, const Depth depth) {
    const float inverse_scale = 1.0f / depth.scale;
    const float2 left = (float2)(-spine.along.y, spine.along.x);
    const lanes_float x = spine.p.x + spine.d.x * u;
    const lanes_float y = spine.p.y + spine.d.y * u;
    const lanes_float side_texels = side * depth.scale;
    /* Vectors on both sides: Oclgrind reads past a scalar beside a vector in min and max. */
    const lanes_int none = 0, right = depth.size.x - 1, top = depth.size.y - 1;
    const lanes_int column = min(max(FLOOR_TO_INT(x + left.x * side_texels), none), right);
    const lanes_int row = min(max(FLOOR_TO_INT(y + left.y * side_texels), none), top);
    const lanes_float offset_x = (TO_FLOAT(column) + 0.5f - x) * inverse_scale;
    const lanes_float offset_y = (TO_FLOAT(row) + 0.5f - y) * inverse_scale;
    const lanes_float along = offset_x * spine.along.x + offset_y * spine.along.y;
    const lanes_float across = offset_x * left.x + offset_y * left.y;
    const lanes_float line_depth = (spine.depth_p + spine.depth_d * u) + spine.depth_along * along;
    const lanes_float before =
        depth.tolerance * (spine.inverse_w_p + spine.inverse_w_d * u) + LA_DEPTH_ROUNDING;

    const lanes_int index = row * depth.size.x + column;
    const lanes_float seen = LOAD_LANES(depth.texels, index) - line_depth;
    lanes_int sees = seen >= -before;
    if (ANY(!sees && in_use)) {
        sees = sees || is_own_face(spine.a, seen, across, before) ||
               is_own_face(spine.b, seen, across, before);
    }
    return sees && in_use;
}

#endif
