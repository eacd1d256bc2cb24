/* project_clip: segments to clip space, clipped to the frustum, with their sample counts (§4.1).
 *
 * One work-item per segment. Every operation is written out in a fixed order without contraction, so
 * that sample counts are equal bit by bit on every device. */

#include "segment_table.h"

#pragma OPENCL FP_CONTRACT OFF

/* m: a 4x4 matrix, columns one after the other. */
static float4 transform_point(const float16 m, const float3 v) {
    return (m.s0123 * v.x + m.s4567 * v.y) + (m.s89ab * v.z + m.scdef);
}

/* Liang-Barsky against one plane, given the signed distances of both ends to it (>= 0: inside). */
static bool clip_plane(const float dp, const float dq, float* t0, float* t1) {
    if (dp < 0.0f && dq < 0.0f) return false;
    if (dp < 0.0f) *t0 = fmax(*t0, dp / (dp - dq));
    if (dq < 0.0f) *t1 = fmin(*t1, dp / (dp - dq));
    return true;
}

/* All six planes, in homogeneous coordinates: right for segments that cross the eye plane. */
static bool clip_to_frustum(const float4 p, const float4 q, float* t0, float* t1) {
    *t0 = 0.0f;
    *t1 = 1.0f;
    return clip_plane(p.w + p.z, q.w + q.z, t0, t1) && clip_plane(p.w - p.z, q.w - q.z, t0, t1) &&
           clip_plane(p.w + p.x, q.w + q.x, t0, t1) && clip_plane(p.w - p.x, q.w - q.x, t0, t1) &&
           clip_plane(p.w + p.y, q.w + q.y, t0, t1) && clip_plane(p.w - p.y, q.w - q.y, t0, t1) &&
           *t0 < *t1;
}

/* What a face looks like beside its line on the screen, so that a probe can recognise it: the change of
 * window depth per pixel across the line (to the left), and the height of the third corner above the
 * line in pixels, positive to the left. Each is cut to the upper half of a float. p and q are the ends
 * of the line in clip space, `across` is the unit vector to its left. */
static uint own_face(const uint face, const uint vertex_p, const uint vertex_q, const float4 p,
                     const float4 q, const float2 across, const float length_px,
                     __global const float* vertices, __global const uint* triangles,
                     const float16 clip_from_world, const float16 world_from_clip,
                     const float2 viewport) {
    if (face == LA_NO_FACE) return 0;
    const uint i = face & LA_FACE_INDEX;
    const uint i0 = triangles[3 * i], i1 = triangles[3 * i + 1], i2 = triangles[3 * i + 2];
    const float3 v = vload3(i0, vertices);
    const float3 ab = vload3(i1, vertices) - v;
    const float3 ac = vload3(i2, vertices) - v;
    const float nx = ab.y * ac.z - ab.z * ac.y;
    const float ny = ab.z * ac.x - ab.x * ac.z;
    const float nz = ab.x * ac.y - ab.y * ac.x;
    const float nw = -((nx * v.x + ny * v.y) + nz * v.z);
    /* The plane in clip space: its row vector times world_from_clip. */
    const float16 m = world_from_clip;
    const float a = (nx * m.s0 + ny * m.s1) + (nz * m.s2 + nw * m.s3);
    const float b = (nx * m.s4 + ny * m.s5) + (nz * m.s6 + nw * m.s7);
    const float c = (nx * m.s8 + ny * m.s9) + (nz * m.sa + nw * m.sb);
    const float slope = -(a / viewport.x * across.x + b / viewport.y * across.y) / c;
    /* The corner's side is the sign of a determinant that stays right where the corner is behind the
     * eye; there, and at the eye plane, the face reaches as far as can be. */
    const uint i3 = i0 != vertex_p && i0 != vertex_q ? i0 : i1 != vertex_p && i1 != vertex_q ? i1 : i2;
    const float4 r = transform_point(clip_from_world, vload3(i3, vertices));
    const float det = ((p.y * q.w - p.w * q.y) * r.x + (p.w * q.x - p.x * q.w) * r.y) +
                      (p.x * q.y - p.y * q.x) * r.w;
    const float area = det / (p.w * q.w) * (viewport.x * viewport.y * 0.25f);
    const float height = r.w > 0.0f ? area / (r.w * length_px) : area * LA_HEIGHT_LIMIT;
    const float kept_slope = fmin(fmax(slope, -LA_SLOPE_LIMIT), LA_SLOPE_LIMIT);
    const float kept_height = fmin(fmax(height, -LA_HEIGHT_LIMIT), LA_HEIGHT_LIMIT);
    return (as_uint(kept_slope) >> 16) | (as_uint(kept_height) & 0xFFFF0000u);
}

static bool is_silhouette(const uint face_a, const uint face_b, __global const uchar* front) {
    const uchar flipped = (face_b & LA_FACE_FLIPPED) != 0 ? 1 : 0;
    return front[face_a] != (front[face_b & LA_FACE_INDEX] ^ flipped);
}

/* counts[i]: sample count l (eq. 1); 0 for a segment that is not drawn in this frame.
 * arcs[i]: clipped window length in 1/256 pixels. clipped[i] is written only where l > 0. */
__kernel void project_clip(__global const Segment* restrict segments, const uint count,
                           __global const float* restrict vertices,
                           __global const uint* restrict triangles,
                           __global const uchar* restrict front, const float16 clip_from_world,
                           const float16 world_from_clip, const float2 viewport, const float step,
                           const uint kind_mask, __global ClippedSegment* restrict clipped,
                           __global uint* restrict counts, __global uint* restrict arcs) {
    const uint i = (uint)get_global_id(0);
    if (i >= count) return;
    counts[i] = 0;
    arcs[i] = 0;
    const uint tag = segments[i].tag;
    const uint kind = tag & LA_TAG_KIND_MASK;
    if ((kind_mask & (1u << kind)) == 0) return;
    const uint face_a = segments[i].face_a;
    const uint face_b = segments[i].face_b;
    if (kind == LA_KIND_SILHOUETTE && !is_silhouette(face_a, face_b, front)) return;

    const float4 p = transform_point(clip_from_world, vload3(segments[i].p, vertices));
    const float4 q = transform_point(clip_from_world, vload3(segments[i].q, vertices));
    float t0, t1;
    if (!clip_to_frustum(p, q, &t0, &t1)) return;
    const float4 d = q - p;
    const float4 cp = p + d * t0;
    const float4 cq = t1 < 1.0f ? p + d * t1 : q;

    const float2 span = (cq.xy / cq.w - cp.xy / cp.w) * (viewport * 0.5f);
    const float length_px = sqrt(span.x * span.x + span.y * span.y);
    uint l = (uint)ceil(length_px / step);
    if (l <= 1) {
        if ((tag & LA_TAG_LONE) != 0) return;
        l = 1; /* a path must not look broken (§4.1) */
    }
    counts[i] = l;
    arcs[i] = (uint)(length_px * LA_ARC_UNITS_PER_PIXEL);
    vstore4(cp, 0, clipped[i].p);
    vstore4(cq, 0, clipped[i].q);
    clipped[i].t0 = t0;
    clipped[i].t1 = t1;
    const float2 across = (float2)(-span.y, span.x) / length_px;
    const uint p_index = segments[i].p, q_index = segments[i].q;
    clipped[i].own_a = own_face(face_a, p_index, q_index, cp, cq, across, length_px, vertices,
                                triangles, clip_from_world, world_from_clip, viewport);
    clipped[i].own_b = own_face(face_b, p_index, q_index, cp, cq, across, length_px, vertices,
                                triangles, clip_from_world, world_from_clip, viewport);
}
