/* atlas: the visibility of every sample of every segment (§4.2, §4.3), the compute form.
 *
 * One work-item per block of `block` neighbouring samples: it finds the segment of its first sample
 * by bisection and walks on from there.
 *
 * TILED: `depth` holds only a part of the depth buffer, and only samples in its core are computed.
 *
 * PROBES_PER_AXIS: 1, 2, 3 or 4. PROBE_LANES: 1 probes one after the other (GPUs), 4 or 16 all
 * probes of a sample in one vector (CPUs); at least the number of probes then. */

#include "atlas_address.h"
#include "segment_table.h"

#pragma OPENCL FP_CONTRACT OFF

#if !defined(PROBES_PER_AXIS) || !defined(PROBE_LANES)
#error "PROBES_PER_AXIS and PROBE_LANES must be set"
#endif
#define PROBES (PROBES_PER_AXIS * PROBES_PER_AXIS)

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

/* The last segment that starts at or before sample s; it has samples. */
static uint segment_of_sample(__global const uint* offsets, const uint count, const uint s) {
    uint low = 0, high = count;
    while (high - low > 1) {
        const uint middle = low + (high - low) / 2;
        if (offsets[middle] <= s)
            low = middle;
        else
            high = middle;
    }
    return low;
}

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

/* How many probes see sample j. They fill a box one pixel wide across the line and one sample long
 * along it (§3.2, §4.3), each row and column of them a little further along than the one before, so
 * that no two are at the same place along or across the line. A probe sees the line if nothing in
 * the depth buffer stands before it by more than the tolerance, or if what stands there is one of
 * the line's own two faces: their planes are known, so they need no bias. tolerance is in window
 * depth times w. A single probe on a smooth silhouette would hit the surface or miss it by chance,
 * and the outline would be dashed; it stands outside instead. */
static uint count_visible(const Spine spine, const uint j, __global const float* depth,
                          const int2 depth_size, const float depth_scale, const float tolerance) {
    const float inverse_scale = 1.0f / depth_scale;
    const float2 left = (float2)(-spine.along.y, spine.along.x);
    const float shift =
        PROBES_PER_AXIS == 1 ? spine.outside * LA_FOLD_CLEARANCE * inverse_scale : 0.0f;
    const float middle = 0.5f * (PROBES_PER_AXIS - 1);
    uint visible = 0;
    for (int first = 0; first < PROBES; first += PROBE_LANES) {
        const lanes_int probe = LANE_INDEX + first;
        const lanes_int row = probe / PROBES_PER_AXIS;
        const lanes_int column = probe - row * PROBES_PER_AXIS;
        const lanes_float row_shift = (TO_FLOAT(column) - middle) * (1.0f / PROBES);
        const lanes_float column_shift = (TO_FLOAT(row) - middle) * (1.0f / PROBES);
        const lanes_float row_place = (TO_FLOAT(row) + 0.5f) * (1.0f / PROBES_PER_AXIS) + row_shift;
        const lanes_float side =
            (TO_FLOAT(column) + 0.5f) * (1.0f / PROBES_PER_AXIS) - 0.5f + column_shift + shift;

        const lanes_float u = ((float)j + row_place) * spine.inverse_l;
        const lanes_float x = spine.p.x + spine.d.x * u;
        const lanes_float y = spine.p.y + spine.d.y * u;
        const lanes_float side_texels = side * depth_scale;
        const lanes_int column_texel =
            min(max(FLOOR_TO_INT(x + left.x * side_texels), 0), depth_size.x - 1);
        const lanes_int row_texel =
            min(max(FLOOR_TO_INT(y + left.y * side_texels), 0), depth_size.y - 1);
        const lanes_float offset_x = (TO_FLOAT(column_texel) + 0.5f - x) * inverse_scale;
        const lanes_float offset_y = (TO_FLOAT(row_texel) + 0.5f - y) * inverse_scale;
        const lanes_float along = offset_x * spine.along.x + offset_y * spine.along.y;
        const lanes_float across = offset_x * left.x + offset_y * left.y;
        const lanes_float line_depth =
            (spine.depth_p + spine.depth_d * u) + spine.depth_along * along;
        const lanes_float before =
            tolerance * (spine.inverse_w_p + spine.inverse_w_d * u) + LA_DEPTH_ROUNDING;

        const lanes_int index = row_texel * depth_size.x + column_texel;
        const lanes_float seen = LOAD_LANES(depth, index) - line_depth;
        const lanes_int in_use = probe < PROBES;
        lanes_int sees = seen >= -before;
        if (ANY(!sees && in_use)) {
            sees = sees || is_own_face(spine.a, seen, across, before) ||
                   is_own_face(spine.b, seen, across, before);
        }
        visible += (uint)COUNT(sees && in_use);
    }
    return visible;
}

#ifdef TILED
/* Judged by the place in the whole picture, which is the same in every tile to the last bit: so
 * each sample is in exactly one core. */
static bool is_in_core(const float2 whole_p, const Spine spine, const uint j, const int4 core) {
    const float2 place = whole_p + spine.d * (((float)j + 0.5f) * spine.inverse_l);
    const int x = convert_int_sat_rtn(place.x), y = convert_int_sat_rtn(place.y);
    return x >= core.x && y >= core.y && x < core.z && y < core.w;
}
#endif

/* alpha: one byte per sample at its atlas address, 0 to 255. Samples at or beyond `capacity` are
 * left out: the host sees the total, enlarges the atlas and runs the kernel again. For TILED alone:
 * origin is the first texel of `depth` in the whole, core the texels from xy up to zw, without. */
__kernel void atlas(__global const ClippedSegment* restrict clipped,
                    __global const uint* restrict offsets, const uint count,
                    __global const float* restrict depth, const int2 depth_size,
                    const float2 viewport, const float depth_scale, const float tolerance,
                    const uint width, const uint pitch, const uint capacity, const uint block,
                    const int2 origin, const int4 core, __global uchar* restrict alpha) {
    const uint total = min(offsets[count], capacity);
    const uint first = (uint)get_global_id(0) * block;
    if (first >= total) return;
    const uint last = min(first + block, total);
    uint i = segment_of_sample(offsets, count, first);
    uint s = first;
    while (s < last) {
        const uint begin = offsets[i];
        const uint end = offsets[i + 1];
        if (end <= s) {
            ++i;
            continue;
        }
        Spine spine = make_spine(clipped + i, viewport, depth_scale, end - begin);
#ifdef TILED
        const float2 whole_p = spine.p;
        spine.p -= convert_float2(origin);
#endif
        const uint address = atlas_address(begin, width, pitch);
        const uint stop = min(end, last);
        for (; s < stop; ++s) {
#ifdef TILED
            if (!is_in_core(whole_p, spine, s - begin, core)) continue;
#endif
            const uint visible =
                count_visible(spine, s - begin, depth, depth_size, depth_scale, tolerance);
            alpha[address + s - begin] = (uchar)((visible * 255u + PROBES / 2u) / PROBES);
        }
        ++i;
    }
}
