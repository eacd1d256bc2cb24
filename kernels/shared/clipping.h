/* From the model to the screen: what `project_clip` and the spine pass share. */
#ifndef LINEATLAS_CLIPPING_H
#define LINEATLAS_CLIPPING_H

#include "shared/constants.h"
#include "shared/language.h"
#include "shared/own_face.h"

FUNCTION float4 transform_point(const Matrix m, const float3 v) {
    return (m.x * v.x + m.y * v.y) + (m.z * v.z + m.w);
}

/* Liang-Barsky against one plane, given the signed distances of both ends to it (>= 0: inside).
 * range: clip parameters so far. Nothing is left of the segment if x is not below y. */
FUNCTION float2 clip_plane(const float2 range, const float dp, const float dq) {
    if (dp < 0.0f && dq < 0.0f) return float2(1.0f, 0.0f);
    float2 left = range;
    if (dp < 0.0f) left.x = fmax(left.x, dp / (dp - dq));
    if (dq < 0.0f) left.y = fmin(left.y, dp / (dp - dq));
    return left;
}

/* All six planes, in homogeneous coordinates: right for segments that cross the eye plane. */
FUNCTION float2 clip_to_frustum(const float4 p, const float4 q) {
    float2 range = clip_plane(float2(0.0f, 1.0f), p.w + p.z, q.w + q.z);
    range = clip_plane(range, p.w - p.z, q.w - q.z);
    range = clip_plane(range, p.w + p.x, q.w + q.x);
    range = clip_plane(range, p.w - p.x, q.w - q.x);
    range = clip_plane(range, p.w + p.y, q.w + q.y);
    return clip_plane(range, p.w - p.y, q.w - q.y);
}

/* Twice the area of a triangle times its normal, counter-clockwise. */
FUNCTION float3 face_normal(const float3 a, const float3 b, const float3 c) {
    const float3 ab = b - a, ac = c - a;
    return float3(ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x);
}

/* True if a triangle shows its front to the eye, given in homogeneous coordinates. There are no
 * square roots, because devices round these as they like. If the squares are too small for a float,
 * the sign of `rise` decides alone. */
FUNCTION bool faces_eye(const float3 a, const float3 b, const float3 c, const float4 eye) {
    const float3 n = face_normal(a, b, c);
    const float3 to_eye = xyz(eye) - a * eye.w;
    const float rise = (n.x * to_eye.x + n.y * to_eye.y) + n.z * to_eye.z;
    const float n2 = (n.x * n.x + n.y * n.y) + n.z * n.z;
    const float far2 = (to_eye.x * to_eye.x + to_eye.y * to_eye.y) + to_eye.z * to_eye.z;
    return rise > 0.0f && rise * rise >= LA_EDGE_ON * LA_EDGE_ON * n2 * far2;
}

/* Which corner of a face, 0 to 2, is farthest from the line through p and q. */
FUNCTION uint farthest_corner(const float3 a, const float3 b, const float3 c, const float3 p,
                              const float3 q) {
    const float3 of_a = face_normal(p, q, a), of_b = face_normal(p, q, b),
                 of_c = face_normal(p, q, c);
    const float at_a = (of_a.x * of_a.x + of_a.y * of_a.y) + of_a.z * of_a.z;
    const float at_b = (of_b.x * of_b.x + of_b.y * of_b.y) + of_b.z * of_b.z;
    const float at_c = (of_c.x * of_c.x + of_c.y * of_c.y) + of_c.z * of_c.z;
    return at_a > at_b && at_a > at_c ? 0u : at_b > at_c ? 1u : 2u;
}

/* The description of a face, changed to say that the line runs within the face. */
FUNCTION uint within_own_face(const uint description) {
    return (description & 0x0000FFFFu) | (as_uint(LA_BOTH_SIDES) & 0xFFFF0000u);
}

/* Describes how a face looks beside its line on the screen, so that a probe can recognise the face.
 * Two numbers are kept, each as the upper half of a float: the change of window depth per pixel
 * across the line (to the left), and the height of the third corner above the line in pixels,
 * positive to the left. p and q are the ends of the line in clip space, `across` is the unit vector
 * to its left; a, b and c are the face's corners, `third` the one that is not on the line. */
FUNCTION uint describe_own_face(const float3 a, const float3 b, const float3 c, const float3 third,
                                const float4 p, const float4 q, const float2 across,
                                const float length_px, const Matrix clip_from_world,
                                const Matrix world_from_clip, const float2 viewport) {
    const float3 n = face_normal(a, b, c);
    const float nw = -((n.x * a.x + n.y * a.y) + n.z * a.z);
    /* The plane in clip space: its row vector times world_from_clip. */
    const Matrix m = world_from_clip;
    const float x = (n.x * m.x.x + n.y * m.x.y) + (n.z * m.x.z + nw * m.x.w);
    const float y = (n.x * m.y.x + n.y * m.y.y) + (n.z * m.y.z + nw * m.y.w);
    const float z = (n.x * m.z.x + n.y * m.z.y) + (n.z * m.z.z + nw * m.z.w);
    const float slope = -(x / viewport.x * across.x + y / viewport.y * across.y) / z;
    /* The side of the corner is the sign of a determinant, which stays right if the corner is
     * behind the eye. For such a corner, or one at the eye plane, the face reaches as far as can
     * be. */
    const float4 r = transform_point(clip_from_world, third);
    const float det = ((p.y * q.w - p.w * q.y) * r.x + (p.w * q.x - p.x * q.w) * r.y) +
                      (p.x * q.y - p.y * q.x) * r.w;
    const float area = det / (p.w * q.w) * (viewport.x * viewport.y * 0.25f);
    const float height = r.w > 0.0f ? area / (r.w * length_px) : area * LA_HEIGHT_LIMIT;
    const float kept_slope = fmin(fmax(slope, -LA_SLOPE_LIMIT), LA_SLOPE_LIMIT);
    const float kept_height = fmin(fmax(height, -LA_HEIGHT_LIMIT), LA_HEIGHT_LIMIT);
    return (as_uint(kept_slope) >> 16) | (as_uint(kept_height) & 0xFFFF0000u);
}

/* How far before the line, in window depth, a probe may still take what it sees for this own face
 * (is_own_face in spine.h). reach: pixels between the line and the centre of any texel that is
 * probed. */
FUNCTION float own_depth(const uint bits, const float reach, const float before) {
    const float slope = fabs(as_float(bits << 16));
    const float height = fabs(as_float(bits & 0xFFFF0000u));
    const float within = slope * fmin(height + LA_OWN_FACE_SNAP, reach);
    return fmin(slope * reach, fmax(within, LA_OWN_FACE_REACH * before));
}

/* True if every probe of every sample of a clipped segment is sure to be blocked: no tile of the
 * depth pyramid that a probe can touch has a texel as far away as the line less all tolerances. p,
 * d: window position in pixels and depth of one end, and the way to the other. nearest_w: the
 * smaller w of the two; tolerance: in window depth, times w. */
FUNCTION bool is_hidden(TABLE_ARGUMENT(float, tiles) const float3 p, const float3 d,
                        const float nearest_w, const uint own_a, const uint own_b,
                        const float depth_scale, const float tolerance, const int2 tile_count) {
    const float length_px = sqrt(d.x * d.x + d.y * d.y);
    const int pieces = int_of(length_px * depth_scale * (1.0f / LA_TILE)) + 1;
    if (pieces > LA_MOST_TILES_TESTED) return false;
    const float before = tolerance / nearest_w + LA_DEPTH_ROUNDING;
    const float reach = LA_PROBE_REACH(depth_scale); /* texels */
    const float reach_px = reach / depth_scale;
    const float own = fmax(own_depth(own_a, reach_px, before), own_depth(own_b, reach_px, before));
    const float along = length_px > 0.0f ? fabs(d.z) / length_px * reach_px : 0.0f;
    const float margin = before + own + along + 2.0f * LA_DEPTH_ROUNDING;
    const float3 texels = float3(depth_scale, depth_scale, 1.0f);
    const float3 start = p * texels, way = d * texels;
    const float per_piece = 1.0f / float_of(pieces);
    for (int i = 0; i < pieces; ++i) {
        const float3 a = start + way * (float_of(i) * per_piece);
        const float3 b = start + way * (float_of(i + 1) * per_piece);
        const float nearest = fmin(a.z, b.z) - margin;
        const float2 low = (fmin(xy(a), xy(b)) - reach) * (1.0f / LA_TILE);
        const float2 high = (fmax(xy(a), xy(b)) + reach) * (1.0f / LA_TILE);
        /* Rounding is towards zero: values below zero are clamped to the first tile either way. */
        const int2 first = clamp(convert_int2(low), int2(0, 0), tile_count - 1);
        const int2 last = clamp(convert_int2(high), int2(0, 0), tile_count - 1);
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                if (TABLE_AT(tiles, y * tile_count.x + x) >= nearest) return false;
            }
        }
    }
    return true;
}

#endif
