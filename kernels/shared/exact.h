/* What the kernels of the exact method share: faces on the screen, as the tiles see them
 * (surfaces.cl, tile_lists.cl, visible.cl). No depth buffer and no samples: a face is three sides
 * and a plane, all linear on the screen.
 *
 * The rule of what hides what, the same for all lines: a face hides a point of a line if the ray
 * from the eye to the point goes through the face, not before the near plane, and the point lies
 * farther behind the face's plane than `contact`. A point nearer to the plane touches the face. So
 * do a box and the floor that it stands on, coincident faces, the third face at a corner, and the
 * faces beside the line itself. A corner that is an end of the line lies in the face exactly. */
#ifndef LINEATLAS_EXACT_H
#define LINEATLAS_EXACT_H

#include "kernels.h"
#include "shared/clipping.h"

/* Faces flatter to the eye than this (sine) are seen from the edge and hide nothing: rounding would
 * decide which side of them the eye is on. */
#define EDGE_ON 1e-6f
/* The depth of a face lower than this on the screen, in pixels, is not computed from its place
 * there. */
#define LEAST_HEIGHT 0.01f
/* Rounding of a float, with some to spare. */
#define FEW_ULPS 5e-7f
/* Share of nearness, and of its change in a pixel, below which two depths are compared in space. */
#define NEARNESS_DOUBT 3e-5f
#define PLACE_DOUBT 1e-3f
/* A face that covers a whole tile does so by at least this many pixels. */
#define COVER_MARGIN 0.01f

/* ScreenFace.kind */
#define FACE_UNSEEN 0u  /* hides nothing in this picture */
#define FACE_PLAIN 1u   /* all before the near plane */
#define FACE_CROSSES 2u /* goes through it */

/* A function that is linear on the screen: a x + b y + c. */
typedef struct Linear {
    float a, b, c;
} Linear;

/* A face in the coordinates of a tile: its three sides, each as pixels inside of it, its nearness,
 * and the largest error of the nearness. */
typedef struct TileFace {
    Linear sides[3];
    Linear nearness;
    float doubt;
} TileFace;

/* True if the lists hold all of the frame. If they do not, the host enlarges them and does the
 * frame again. */
static bool lists_fit(const ExactParameters* args, const uint entries, const uint groups) {
    return entries <= args->entry_capacity && groups <= args->group_capacity;
}

/* args->slices, or 1: it is 0 if there is nothing to do. */
static uint slices_of(const ExactParameters* args) {
    return max(args->slices, 1u);
}

/* What work-item i has a slice of, and which slice. There is no division on a CPU, which has no
 * slices. */
static uint sliced(const ExactParameters* args, const uint i) {
    return args->slices > 1u ? i / args->slices : i;
}

static uint slice_of(const ExactParameters* args, const uint i) {
    return args->slices > 1u ? i % args->slices : 0;
}

static float least_in(const Linear f, const float size) {
    return f.c + fmin(f.a, 0.0f) * size + fmin(f.b, 0.0f) * size;
}

static float most_in(const Linear f, const float size) {
    return f.c + fmax(f.a, 0.0f) * size + fmax(f.b, 0.0f) * size;
}

/* Nearness grows towards the eye and is linear on the screen: 1/w, or 1 - z in a parallel view. */
static float nearness_of(const ExactParameters* args, const float4 clip) {
    return args->depth_rate > 0.0f ? 1.0f - clip.z : 1.0f / clip.w;
}

/* The most by which nearness differs between a plane and a point that touches it from behind.
 * reach: the distance of the plane from the eye, or in a parallel view the sine between them. */
static float contact_nearness(const ExactParameters* args, const float nearness,
                              const float reach) {
    const float rate = args->depth_rate > 0.0f ? args->depth_rate : nearness;
    return args->contact * rate / reach;
}

/* How wrong a nearness may be because positions are rounded when they are projected. */
static float projection_doubt(const ExactParameters* args, const float nearness) {
    return args->rounding * (args->depth_rate > 0.0f ? 1.0f : nearness * nearness);
}

/* The side through b and c, with the inside to the left of the way from b to c if sign is 1. The
 * corner nearer to the tile's origin carries it, so that both faces of an edge find the same line,
 * bit by bit. */
static Linear plain_side(const float2 b, const float2 c, const float sign) {
    const float2 way = c - b;
    const float scale = sign / (fabs(way.x) + fabs(way.y));
    const float2 through = fabs(b.x) + fabs(b.y) <= fabs(c.x) + fabs(c.y) ? b : c;
    Linear side;
    side.a = -way.y * scale;
    side.b = way.x * scale;
    side.c = -(side.a * through.x + side.b * through.y);
    return side;
}

/* The clipped ends of a segment, of a contour lifted off its surface. */
typedef struct ClipEnds {
    float4 p, q;
} ClipEnds;

/* A vertex of a contour, `times` as far off the surface as its lifted vertex, to the side that it
 * is seen from. */
static float3 lifted_vertex(__global const Segment* segment, const uint vertex, const uint lift,
                            const float times, __global const float* vertices) {
    const float3 at = vload3(vertex, vertices), way = vload3(vertex + lift, vertices) - at;
    return at + way * ((segment->tag & LA_TAG_UNDERSIDE) != 0 ? -times : times);
}

static ClipEnds lifted_ends(__global const Segment* segment, __global const ClippedSegment* clipped,
                            const uint lift, const Matrix clip_from_world,
                            __global const float* vertices) {
    ClipEnds ends;
    ends.p = vload4(0, clipped->p);
    ends.q = vload4(0, clipped->q);
    if ((segment->tag & LA_TAG_CONTOUR) == 0) return ends;
    const float4 p =
        transform_point(clip_from_world, lifted_vertex(segment, segment->p, lift, 1.0f, vertices));
    const float4 q =
        transform_point(clip_from_world, lifted_vertex(segment, segment->q, lift, 1.0f, vertices));
    const float4 at_p = p + (q - p) * clipped->t0, at_q = p + (q - p) * clipped->t1;
    if (!(at_p.w > 0.0f && at_q.w > 0.0f)) return ends;
    ends.p = at_p;
    ends.q = at_q;
    return ends;
}

/* A corner in homogeneous pixels of a tile. */
static float3 homogeneous(const float4 clip, const float2 viewport, const float2 origin) {
    const float2 half_size = viewport * 0.5f;
    return float3((clip.x + clip.w) * half_size.x - origin.x * clip.w,
                  (clip.y + clip.w) * half_size.y - origin.y * clip.w, clip.w);
}

static float3 cross_product(const float3 a, const float3 b) {
    return float3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static float dot_product(const float3 a, const float3 b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

static Linear scaled(const float3 f, const float sign) {
    const float scale = sign / (fabs(f.x) + fabs(f.y));
    const Linear line = {f.x * scale, f.y * scale, f.z * scale};
    return line;
}

/* Sides of a face that goes through the near plane. They are right wherever its corners are, for a
 * ray goes through the face if it is a sum of the rays to the corners. `near`: inside where the ray
 * hits the face beyond the near plane. Returns false if the face is seen from the edge. */
static bool crossing_sides(const ExactParameters* args, const uint t,
                           __global const float* vertices, __global const uint* triangles,
                           const float2 origin, Linear* sides, Linear* near) {
    const Matrix m = to_matrix(args->clip_from_world);
    const float2 viewport = to_float2(args->viewport);
    float4 clip[3];
    float3 v[3];
    for (int k = 0; k < 3; ++k) {
        clip[k] = transform_point(m, vload3(triangles[3 * t + k], vertices));
        v[k] = homogeneous(clip[k], viewport, origin);
    }
    const float3 across[3] = {cross_product(v[1], v[2]), cross_product(v[2], v[0]),
                              cross_product(v[0], v[1])};
    const float turn = dot_product(v[0], across[0]);
    if (turn == 0.0f) return false;
    const float sign = turn < 0.0f ? -1.0f : 1.0f;
    float3 before = float3(0.0f, 0.0f, 0.0f);
    for (int k = 0; k < 3; ++k) {
        sides[k] = scaled(across[k], sign);
        before += across[k] * (clip[k].z + clip[k].w);
    }
    *near = scaled(before, sign);
    return true;
}

/* Face t as the tile at `origin` sees it. reach: see contact_nearness. Returns false if the face
 * hides nothing. */
static bool face_in_tile(const ExactParameters* args, const uint t, const uint kind,
                         const float reach, __global const float* vertices,
                         __global const uint* triangles, __global const float* screen,
                         const float2 origin, TileFace* face) {
    if (kind == FACE_CROSSES) {
        Linear near;
        face->nearness.a = face->nearness.b = face->nearness.c = 0.0f;
        face->doubt = INFINITY;
        return crossing_sides(args, t, vertices, triangles, origin, face->sides, &near);
    }
    const float4 s0 = vload4(triangles[3 * t], screen);
    const float4 s1 = vload4(triangles[3 * t + 1], screen);
    const float4 s2 = vload4(triangles[3 * t + 2], screen);
    const float2 p0 = xy(s0) - origin, p1 = xy(s1) - origin, p2 = xy(s2) - origin;
    const float2 u = p1 - p0, v = p2 - p0;
    const float area = u.x * v.y - u.y * v.x;
    if (area == 0.0f) return false;
    const float sign = area < 0.0f ? -1.0f : 1.0f;
    face->sides[0] = plain_side(p1, p2, sign);
    face->sides[1] = plain_side(p2, p0, sign);
    face->sides[2] = plain_side(p0, p1, sign);
    const float du = s1.z - s0.z, dv = s2.z - s0.z;
    const float a = (du * v.y - dv * u.y) / area, b = (dv * u.x - du * v.x) / area;
    face->nearness.a = a;
    face->nearness.b = b;
    face->nearness.c = s0.z - (a * p0.x + b * p0.y);
    const float longest = fmax(fmax(fabs(u.x) + fabs(u.y), fabs(v.x) + fabs(v.y)),
                               fabs(p2.x - p1.x) + fabs(p2.y - p1.y));
    const float nearest = fmax(s0.z, fmax(s1.z, s2.z));
    face->doubt = contact_nearness(args, nearest, reach) + projection_doubt(args, nearest) +
                  (fabs(a) + fabs(b)) * PLACE_DOUBT +
                  (fabs(a * p0.x) + fabs(b * p0.y) + fabs(s0.z)) * FEW_ULPS;
    if (!(fabs(area) >= LEAST_HEIGHT * longest)) {
        face->nearness.a = face->nearness.b = face->nearness.c = 0.0f;
        face->doubt = INFINITY;
    }
    return true;
}

/* The tiles that a face may lie in, from xy up to zw. */
static int4 tiles_of(const ExactParameters* args, const ScreenFace face) {
    const int2 last = to_int2(args->tiles) - 1;
    const float scale = 1.0f / args->tile_size;
    return int4(clamp((int)(fmax(face.low[0], 0.0f) * scale), 0, last.x),
                clamp((int)(fmax(face.low[1], 0.0f) * scale), 0, last.y),
                clamp((int)(fmin(face.high[0] * scale, (float)last.x)), 0, last.x),
                clamp((int)(fmin(face.high[1] * scale, (float)last.y)), 0, last.y));
}

/* The greatest nearness of a face within the tile; below 0 if the face is not in the tile after
 * all. */
static float nearness_in_tile(const ExactParameters* args, const TileFace* face,
                              const float nearest) {
    const float size = args->tile_size;
    for (int k = 0; k < 3; ++k) {
        if (most_in(face->sides[k], size) < -2.0f * args->slack) return -1.0f;
    }
    if (face->doubt == INFINITY) return nearest;
    return fmin(nearest, most_in(face->nearness, size) + face->doubt);
}

#endif
