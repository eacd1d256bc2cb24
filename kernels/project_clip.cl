/* project_clip: segments to clip space, clipped to the frustum, with their sample counts (§4.1).
 *
 * One work-item per segment. Every operation is written out in a fixed order without contraction,
 * so that sample counts are equal bit by bit on every device. */

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

/* What a face looks like beside its line on the screen, so that a probe can recognise it: the
 * change of window depth per pixel across the line (to the left), and the height of the third
 * corner above the line in pixels, positive to the left. Each is cut to the upper half of a float.
 * p and q are the ends of the line in clip space, `across` is the unit vector to its left. */
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
    /* The corner's side is the sign of a determinant that stays right where the corner is behind
     * the eye; there, and at the eye plane, the face reaches as far as can be. */
    const uint i3 = i0 != vertex_p && i0 != vertex_q   ? i0
                    : i1 != vertex_p && i1 != vertex_q ? i1
                                                       : i2;
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

/* How far before the line a probe may take what it sees for this own face (is_own_face in
 * atlas.cl), in window depth. reach: pixels between the line and the centre of any texel that is
 * probed. */
static float own_depth(const uint packed, const float reach, const float before) {
    const float slope = fabs(as_float(packed << 16));
    const float height = fabs(as_float(packed & 0xFFFF0000u));
    const float within = slope * fmin(height + LA_OWN_FACE_SNAP, reach);
    return fmin(slope * reach, fmax(within, LA_OWN_FACE_REACH * before));
}

/* Whether every probe of every sample of the segment is sure to be blocked: in no tile that a probe
 * can touch is there a texel as far away as the line less all tolerances. p, d: window position in
 * texels and depth of one end, and the way to the other. reach: texels between the line and what
 * probes touch. */
static bool is_hidden(const float3 p, const float3 d, const float length_texels, const float reach,
                      const float depth_margin, __global const float* tiles,
                      const int2 tile_count) {
    const int pieces = (int)(length_texels * (1.0f / LA_TILE)) + 1;
    if (pieces > LA_MOST_TILES_TESTED) return false;
    const float per_piece = 1.0f / (float)pieces;
    for (int i = 0; i < pieces; ++i) {
        const float3 a = p + d * ((float)i * per_piece);
        const float3 b = p + d * ((float)(i + 1) * per_piece);
        const float nearest = fmin(a.z, b.z) - depth_margin;
        const float2 low = (fmin(a.xy, b.xy) - reach) * (1.0f / LA_TILE);
        const float2 high = (fmax(a.xy, b.xy) + reach) * (1.0f / LA_TILE);
        const int2 first = clamp(convert_int2_rtn(low), (int2)(0, 0), tile_count - 1);
        const int2 last = clamp(convert_int2_rtn(high), (int2)(0, 0), tile_count - 1);
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                if (tiles[y * tile_count.x + x] >= nearest) return false;
            }
        }
    }
    return true;
}

/* counts[i]: sample count l (eq. 1); 0 for a segment that is not drawn in this frame.
 * arcs[i]: clipped window length in 1/256 pixels, also of segments that the pyramid shows hidden:
 * the texture of a path must not depend on what hides it. clipped[i] is written where arcs[i] is
 * not 0. use_tiles 0: keep hidden segments;
 * 2: they are drawn too, though without samples, so clipped[i] is written. */
__kernel void project_clip(__global const Segment* restrict segments, const uint count,
                           __global const float* restrict vertices,
                           __global const uint* restrict triangles,
                           __global const uchar* restrict front, const float16 clip_from_world,
                           const float16 world_from_clip, const float2 viewport, const float step,
                           const uint kind_mask, __global const float* restrict tiles,
                           const int2 tile_count, const uint use_tiles, const float depth_scale,
                           const float tolerance, __global ClippedSegment* restrict clipped,
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
    const float4 way = q - p;
    const float4 cp = p + way * t0;
    const float4 cq = t1 < 1.0f ? p + way * t1 : q;

    const float3 scale = (float3)(viewport * 0.5f, 0.5f);
    const float3 window_p = (cp.xyz / cp.w + 1.0f) * scale;
    const float3 d = (cq.xyz / cq.w + 1.0f) * scale - window_p;
    const float length_px = sqrt(d.x * d.x + d.y * d.y);
    uint l = (uint)ceil(length_px / step);
    if (l <= 1) {
        if ((tag & LA_TAG_LONE) != 0) return;
        l = 1; /* a path must not look broken (§4.1) */
    }
    const float2 across = (float2)(-d.y, d.x) / length_px;
    const uint p_index = segments[i].p, q_index = segments[i].q;
    const uint own_a = own_face(face_a, p_index, q_index, cp, cq, across, length_px, vertices,
                                triangles, clip_from_world, world_from_clip, viewport);
    const uint own_b = own_face(face_b, p_index, q_index, cp, cq, across, length_px, vertices,
                                triangles, clip_from_world, world_from_clip, viewport);
    arcs[i] = max((uint)(length_px * LA_ARC_UNITS_PER_PIXEL), 1u);
    if (use_tiles != 0) {
        const float before = tolerance / fmin(cp.w, cq.w) + LA_DEPTH_ROUNDING;
        const float reach_texels = LA_PROBE_REACH(depth_scale);
        const float reach = reach_texels / depth_scale;
        const float own = fmax(own_depth(own_a, reach, before), own_depth(own_b, reach, before));
        const float along = length_px > 0.0f ? fabs(d.z) / length_px * reach : 0.0f;
        const float margin = before + own + along + 2.0f * LA_DEPTH_ROUNDING;
        const float3 texels = (float3)(depth_scale, depth_scale, 1.0f);
        if (is_hidden(window_p * texels, d * texels, length_px * depth_scale, reach_texels, margin,
                      tiles, tile_count)) {
            /* Neighbours of its path still need to know where it runs. */
            const bool alone = (segments[i].from_start | segments[i].to_end) == 0;
            if (alone && use_tiles == 1) return;
            l = 0;
        }
    }
    counts[i] = l;
    vstore4(cp, 0, clipped[i].p);
    vstore4(cq, 0, clipped[i].q);
    clipped[i].t0 = t0;
    clipped[i].t1 = t1;
    clipped[i].own_a = own_a;
    clipped[i].own_b = own_b;
}
