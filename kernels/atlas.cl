/* atlas: the visibility of every sample of every segment (§4.2, §4.3), the compute form.
 *
 * One work-item per block of `block` neighbouring samples: it finds the segment of its first sample by
 * bisection and walks on from there. */

#include "segment_table.h"

#pragma OPENCL FP_CONTRACT OFF

/* Eq. 2, as an index into rows of `pitch` texels of which the first `width` can start a segment:
 * wrapped if width equals pitch, else with a gutter. Sample j of a segment is at the segment's
 * address + j. */
static uint atlas_address(const uint s, const uint width, const uint pitch) {
    return s / width * pitch + s % width;
}

/* The last segment that starts at or before sample s; it has samples. */
static uint segment_of_sample(__global const uint* offsets, const uint count, const uint s) {
    uint low = 0, high = count;
    while (high - low > 1) {
        const uint middle = low + (high - low) / 2;
        if (offsets[middle] <= s) low = middle;
        else high = middle;
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

/* A segment in window space, ready for its samples. */
typedef struct Spine {
    float3 p;          /* window position and depth of p' */
    float3 d;          /* q' - p' */
    float inverse_w_p; /* 1/w, linear in window space like depth */
    float inverse_w_d;
    float2 along;      /* unit vector along the segment */
    float depth_along; /* window depth per pixel along it */
    OwnFace a, b;
    float outside;     /* of a fold, both faces on one side (a silhouette): 1 left, -1 right; else 0 */
} Spine;

static Spine make_spine(__global const ClippedSegment* segment, const float2 viewport) {
    const float4 p = vload4(0, segment->p);
    const float4 q = vload4(0, segment->q);
    const float3 scale = (float3)(viewport * 0.5f, 0.5f);
    const float3 wp = (p.xyz / p.w + 1.0f) * scale;
    const float3 wq = (q.xyz / q.w + 1.0f) * scale;
    Spine spine;
    spine.p = wp;
    spine.d = wq - wp;
    spine.inverse_w_p = 1.0f / p.w;
    spine.inverse_w_d = 1.0f / q.w - 1.0f / p.w;
    const float length_px = sqrt(spine.d.x * spine.d.x + spine.d.y * spine.d.y);
    const bool has_length = length_px > 0.0f;
    spine.along = has_length ? spine.d.xy / length_px : (float2)(1.0f, 0.0f);
    spine.depth_along = has_length ? spine.d.z / length_px : 0.0f;
    spine.a = unpack_own_face(segment->own_a);
    spine.b = unpack_own_face(segment->own_b);
    const bool both_left = spine.a.height > 0.0f && spine.b.height > 0.0f;
    const bool both_right = spine.a.height < 0.0f && spine.b.height < 0.0f;
    spine.outside = both_left ? -1.0f : both_right ? 1.0f : 0.0f;
    return spine;
}

/* Whether what a probe sees is the line's own face. seen: its depth less the line's depth beside it;
 * across: pixels to the left of the line; before: the tolerance there, in window depth. */
static bool is_own_face(const OwnFace face, const float seen, const float across, const float before) {
    const float expected = face.slope * across;
    const bool on_side = face.height > 0.0f ? across > -LA_OWN_FACE_SNAP : across < LA_OWN_FACE_SNAP;
    const bool in_reach = fabs(across) <= fabs(face.height) + LA_OWN_FACE_SNAP ||
                          fabs(expected) <= LA_OWN_FACE_REACH * before;
    return on_side && in_reach &&
           fabs(seen - expected) <= fmin(fabs(face.slope) * LA_OWN_FACE_SNAP + LA_DEPTH_ROUNDING, before);
}

/* How many probes see sample j of l. They fill a box one pixel wide across the line and one sample long
 * along it (§3.2, §4.3). A probe sees the line if nothing in the depth buffer stands before it by more
 * than the tolerance, or if what stands there is one of the line's own two faces: their planes are
 * known, so they need no bias. tolerance is in window depth times w.
 * A single probe on a smooth silhouette would hit the surface or miss it by chance, and the outline would
 * be dashed; it stands outside instead. */
static uint count_visible(const Spine spine, const uint j, const uint l, const uint probes_per_axis,
                          __global const float* depth, const int2 depth_size,
                          const float depth_scale, const float tolerance) {
    uint visible = 0;
    const float per_axis = (float)probes_per_axis;
    const float2 left = (float2)(-spine.along.y, spine.along.x);
    const float shift = probes_per_axis == 1 ? spine.outside * LA_FOLD_CLEARANCE / depth_scale : 0.0f;
    for (uint row = 0; row < probes_per_axis; ++row) {
        const float u = ((float)j + ((float)row + 0.5f) / per_axis) / (float)l;
        const float3 point = spine.p + spine.d * u;
        const float before =
            tolerance * (spine.inverse_w_p + spine.inverse_w_d * u) + LA_DEPTH_ROUNDING;
        for (uint column = 0; column < probes_per_axis; ++column) {
            const float side = ((float)column + 0.5f) / per_axis - 0.5f + shift;
            const float2 probe = (point.xy + left * side) * depth_scale;
            const int2 texel = clamp(convert_int2(floor(probe)), (int2)(0, 0), depth_size - 1);
            const float2 offset = (convert_float2(texel) + 0.5f) / depth_scale - point.xy;
            const float along = offset.x * spine.along.x + offset.y * spine.along.y;
            const float across = offset.x * left.x + offset.y * left.y;
            const float line_depth = point.z + spine.depth_along * along;
            const float seen = depth[texel.y * depth_size.x + texel.x] - line_depth;
            const bool clear = seen >= -before;
            visible += clear || is_own_face(spine.a, seen, across, before) ||
                               is_own_face(spine.b, seen, across, before)
                           ? 1u
                           : 0u;
        }
    }
    return visible;
}

/* alpha: one byte per sample at its atlas address, 0 to 255. Samples at or beyond `capacity` are left
 * out: the host sees the total, enlarges the atlas and runs the kernel again. */
__kernel void atlas(__global const ClippedSegment* restrict clipped,
                    __global const uint* restrict offsets, const uint count,
                    __global const float* restrict depth, const int2 depth_size,
                    const float2 viewport, const float depth_scale, const uint probes_per_axis,
                    const float tolerance, const uint width, const uint pitch, const uint capacity,
                    const uint block, __global uchar* restrict alpha) {
    const uint total = min(offsets[count], capacity);
    const uint first = (uint)get_global_id(0) * block;
    if (first >= total) return;
    const uint last = min(first + block, total);
    const uint probes = probes_per_axis * probes_per_axis;
    uint i = segment_of_sample(offsets, count, first);
    uint s = first;
    while (s < last) {
        const uint begin = offsets[i];
        const uint end = offsets[i + 1];
        if (end <= s) {
            ++i;
            continue;
        }
        const Spine spine = make_spine(clipped + i, viewport);
        const uint address = atlas_address(begin, width, pitch);
        const uint stop = min(end, last);
        for (; s < stop; ++s) {
            const uint j = s - begin;
            const uint visible = count_visible(spine, j, end - begin, probes_per_axis, depth, depth_size,
                                               depth_scale, tolerance);
            alpha[address + j] = (uchar)((visible * 255u + probes / 2u) / probes);
        }
        ++i;
    }
}
