/* surfaces: the model in the form that the exact method needs: corners and faces on the screen,
 * planes in space, and faces that hide a whole tile.
 *
 * surfaces_vertices: one work-item per vertex. surfaces_faces: one per triangle. surfaces_boxes,
 * surfaces_occluders, surfaces_batches: one per batch of triangles. surfaces_boxes runs only after
 * the model has changed; surfaces_batches also runs for batches of segments. If there are batches,
 * the kernels run in the order boxes, vertices, occluders, batches, faces, and a batch that is
 * hidden has no faces. Without batches surfaces_faces finds the occluders, too. */

#include "shared/batches.h"
#include "shared/exact.h"

/* screen: four numbers per vertex: window position in pixels, nearness, and 1. For a vertex before
 * the near plane the last number is -1, and the others mean nothing. */
KERNEL(surfaces_vertices, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.vertex_count) return;
    const Matrix m = to_matrix(args.clip_from_world);
    const float4 clip = transform_point(m, vload3(i, vertices));
    const bool is_before = !(clip.w > 0.0f) || clip.z + clip.w < 0.0f;
    const float2 window = (xy(clip) / clip.w + 1.0f) * (to_float2(args.viewport) * 0.5f);
    vstore4(is_before ? float4(0.0f, 0.0f, 0.0f, -1.0f)
                      : float4(window.x, window.y, nearness_of(&args, clip), 1.0f),
            i, screen);
}

/* The plane of a face: its unit normal away from the eye, and the distance of the eye from the
 * plane (in a parallel view the sine between them). The normal is the cross product of the two
 * shorter edges, which loses least. */
static float4 plane_of(const float3 a, const float3 b, const float3 c, const float4 eye) {
    const float3 ab = b - a, bc = c - b, ca = a - c;
    const float ab2 = dot_product(ab, ab), bc2 = dot_product(bc, bc), ca2 = dot_product(ca, ca);
    const float3 normal = ab2 >= bc2 && ab2 >= ca2 ? cross_product(bc, ca)
                          : bc2 >= ca2             ? cross_product(ca, ab)
                                                   : cross_product(ab, bc);
    const float length = sqrt(dot_product(normal, normal));
    if (!(length > 0.0f)) return float4(0.0f, 0.0f, 0.0f, 0.0f);
    const float3 n = normal / length;
    const float3 to_eye = xyz(eye) - a * eye.w;
    const float reach = dot_product(n, to_eye);
    if (fabs(reach) < EDGE_ON * sqrt(dot_product(to_eye, to_eye)))
        return float4(0.0f, 0.0f, 0.0f, 0.0f);
    return reach > 0.0f ? float4(-n.x, -n.y, -n.z, reach) : float4(n.x, n.y, n.z, -reach);
}

static float4 plane_of_face(const ExactParameters* args, const uint t,
                            __global const float* vertices, __global const uint* triangles) {
    return plane_of(vload3(triangles[3 * t], vertices), vload3(triangles[3 * t + 1], vertices),
                    vload3(triangles[3 * t + 2], vertices), to_float4(args->eye));
}

static void enclose(ScreenFace* face, const float2 place) {
    face->low[0] = fmin(face->low[0], place.x);
    face->low[1] = fmin(face->low[1], place.y);
    face->high[0] = fmax(face->high[0], place.x);
    face->high[1] = fmax(face->high[1], place.y);
}

/* The box of the part of a face beyond the near plane. */
static void enclose_crossing(const ExactParameters* args, const uint t,
                             __global const float* vertices, __global const uint* triangles,
                             ScreenFace* face) {
    const Matrix m = to_matrix(args->clip_from_world);
    const float2 half_size = to_float2(args->viewport) * 0.5f;
    for (int k = 0; k < 3; ++k) {
        const float4 p = transform_point(m, vload3(triangles[3 * t + k], vertices));
        const float4 q = transform_point(m, vload3(triangles[3 * t + (k + 1) % 3], vertices));
        const float from = p.z + p.w, to = q.z + q.w;
        if (from >= 0.0f) {
            enclose(face, (xy(p) / p.w + 1.0f) * half_size);
            face->nearest = fmax(face->nearest, nearness_of(args, p));
        }
        if ((from >= 0.0f) == (to >= 0.0f)) continue;
        const float4 cut = p + (q - p) * (from / (from - to));
        if (!(cut.w > 0.0f)) continue;
        enclose(face, (xy(cut) / cut.w + 1.0f) * half_size);
        face->nearest = fmax(face->nearest, nearness_of(args, cut));
    }
}

/* The other half of a quad. */
typedef struct Partner {
    uint face;               /* LA_NO_FACE: there is none */
    float reach;             /* see contact_nearness */
    uint corner, own_corner; /* the corner of the partner, and of the face itself, that the other
                                has not */
} Partner;

/* The corner of triangle t, 0 to 2, that triangle u has not, if u has the other two; else 3. */
static uint odd_corner(const uint t, const uint u, __global const uint* triangles) {
    uint odd = 3u, missing = 0;
    for (uint k = 0; k < 3; ++k) {
        const uint corner = triangles[3 * t + k];
        const bool has = triangles[3 * u] == corner || triangles[3 * u + 1] == corner ||
                         triangles[3 * u + 2] == corner;
        if (has) continue;
        odd = k;
        ++missing;
    }
    return missing == 1u ? odd : 3u;
}

/* The neighbour of face t in the table, if both together are a quad on the screen. Modellers and
 * readers write the halves of quads one after the other. */
static Partner partner_of(const ExactParameters* args, const uint t, const uint u,
                          __global const float* vertices, __global const uint* triangles,
                          __global const float* screen) {
    Partner partner = {LA_NO_FACE, 0.0f, 0, 0};
    if (u >= args->triangle_count)
        return partner; /* also true before the first triangle, as u
                           wraps around */
    partner.own_corner = odd_corner(t, u, triangles);
    partner.corner = odd_corner(u, t, triangles);
    if (partner.own_corner == 3u || partner.corner == 3u) return partner;
    const float4 own = vload4(triangles[3 * t + partner.own_corner], screen);
    const float4 other = vload4(triangles[3 * u + partner.corner], screen);
    const float4 from = vload4(triangles[3 * t + (partner.own_corner + 1u) % 3u], screen);
    const float4 to = vload4(triangles[3 * t + (partner.own_corner + 2u) % 3u], screen);
    if (!(own.w > 0.0f && other.w > 0.0f && from.w > 0.0f && to.w > 0.0f)) return partner;
    /* The two corners lie on either side of the shared edge. */
    const float2 way = xy(to) - xy(from), at_own = xy(own) - xy(from), at = xy(other) - xy(from);
    if (!((way.x * at_own.y - way.y * at_own.x) * (way.x * at.y - way.y * at.x) < 0.0f))
        return partner;
    partner.reach = plane_of_face(args, u, vertices, triangles).w;
    if (partner.reach > 0.0f) partner.face = u;
    return partner;
}

/* How far all of a tile lies inside of a face's sides, except the side opposite a corner. */
static float inside_but(const TileFace* face, const uint corner, const float size) {
    float inside = INFINITY;
    for (uint k = 0; k < 3; ++k) {
        if (k != corner) inside = fmin(inside, least_in(face->sides[k], size));
    }
    return inside;
}

/* A nearness that every point of a face in a tile reaches. */
static float surely_hides(const TileFace* face, const float size) {
    const float farthest = least_in(face->nearness, size);
    return farthest - 2.0f * face->doubt - farthest * NEARNESS_DOUBT;
}

/* Writes occluders of the tiles that the face covers, alone or with its partner. In such a tile,
 * whatever is farther than both faces all over is not seen and hides nothing that is seen. */
static void cover_tiles(const ExactParameters* args, const uint t, const uint slice,
                        const ScreenFace box, const float reach, const Partner partner,
                        __global const float* vertices, __global const uint* triangles,
                        __global const float* screen, __global uint* occluders) {
    const int4 range = tiles_of(args, box);
    const float size = args->tile_size;
    const int columns = to_int2(args->tiles).x;
    TileFace face, other;
    for (int y = range.y + (int)slice; y <= range.w; y += (int)slices_of(args)) {
        for (int x = range.x; x <= range.z; ++x) {
            const float2 origin = float2((float)x, (float)y) * size;
            if (!face_in_tile(args, t, FACE_PLAIN, reach, vertices, triangles, screen, origin,
                              &face))
                return;
            if (face.doubt == INFINITY) return;
            float sure = surely_hides(&face, size);
            if (inside_but(&face, 3u, size) < COVER_MARGIN) {
                if (partner.face == LA_NO_FACE ||
                    inside_but(&face, partner.own_corner, size) < COVER_MARGIN)
                    continue;
                if (!face_in_tile(args, partner.face, FACE_PLAIN, partner.reach, vertices,
                                  triangles, screen, origin, &other) ||
                    other.doubt == INFINITY ||
                    inside_but(&other, partner.corner, size) < COVER_MARGIN)
                    continue;
                sure = fmin(sure, surely_hides(&other, size));
            }
            if (sure > 0.0f) atomic_max(occluders + (y * columns + x), as_uint(sure));
        }
    }
}

/* Where face t is on the screen; FACE_UNSEEN if it is beside the picture. */
static ScreenFace face_on_screen(const ExactParameters* args, const uint t,
                                 __global const float* vertices, __global const uint* triangles,
                                 __global const float* screen) {
    ScreenFace face = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}, 0.0f, FACE_UNSEEN};
    const float4 a = vload4(triangles[3 * t], screen), b = vload4(triangles[3 * t + 1], screen),
                 c = vload4(triangles[3 * t + 2], screen);
    if (a.w > 0.0f && b.w > 0.0f && c.w > 0.0f) {
        face.kind = FACE_PLAIN;
        enclose(&face, xy(a));
        enclose(&face, xy(b));
        enclose(&face, xy(c));
        face.nearest = fmax(a.z, fmax(b.z, c.z));
    } else if (a.w > 0.0f || b.w > 0.0f || c.w > 0.0f) {
        face.kind = FACE_CROSSES;
        enclose_crossing(args, t, vertices, triangles, &face);
    }
    face.nearest *= 1.0f + FEW_ULPS;
    for (int k = 0; k < 2; ++k) {
        face.low[k] -= 2.0f * args->slack;
        face.high[k] += 2.0f * args->slack;
    }
    const float2 viewport = to_float2(args->viewport);
    if (!(face.high[0] >= 0.0f && face.high[1] >= 0.0f && face.low[0] <= viewport.x &&
          face.low[1] <= viewport.y))
        face.kind = FACE_UNSEEN;
    return face;
}

/* True if there may be a tile that the face covers, alone or with its partner. */
static bool may_cover(const ExactParameters* args, const ScreenFace face) {
    return face.kind == FACE_PLAIN && face.high[0] - face.low[0] > args->tile_size &&
           face.high[1] - face.low[1] > args->tile_size;
}

static void find_occluders(const ExactParameters* args, const uint t, const uint slice,
                           const ScreenFace face, const float reach, __global const float* vertices,
                           __global const uint* triangles, __global const float* screen,
                           __global uint* occluders) {
    if (!(reach > 0.0f)) return;
    Partner partner = partner_of(args, t, t + 1u, vertices, triangles, screen);
    if (partner.face == LA_NO_FACE)
        partner = partner_of(args, t, t - 1u, vertices, triangles, screen);
    cover_tiles(args, t, slice, face, reach, partner, vertices, triangles, screen, occluders);
}

/* The most pixels that one model unit takes on the screen, within the picture and where w is at
 * least `least_w`. It follows from the derivative of clip xy / w. */
static float pixels_per_unit(const ExactParameters* args, const float least_w) {
    const Matrix m = to_matrix(args->clip_from_world);
    const float w = sqrt((m.x.w * m.x.w + m.y.w * m.y.w) + m.z.w * m.z.w);
    const float x = sqrt((m.x.x * m.x.x + m.y.x * m.y.x) + m.z.x * m.z.x) + w;
    const float y = sqrt((m.x.y * m.x.y + m.y.y * m.y.y) + m.z.y * m.z.y) + w;
    const float2 half_size = to_float2(args->viewport) * 0.5f;
    return fmax(x * half_size.x, y * half_size.y) / least_w;
}

/* Finds the tiles that faces of a batch cover. One work-item per batch, or per slice of each face.
 * If two faces cover a tile together, the one with the larger share is at least half as wide as the
 * tile. So a batch of narrower faces is passed over. */
KERNEL(surfaces_occluders, ExactParameters) {
    const uint i = (uint)get_global_id(0), slice = slice_of(&args, i);
    const bool in_batches = slices_of(&args) == 1;
    const uint b = in_batches ? i : sliced(&args, i) / LA_BATCH;
    if (b >= args.count) return;
    const BatchOnScreen box =
        batch_on_screen(to_matrix(args.clip_from_world), to_float2(args.viewport), batches + b);
    if (box.is_outside) return;
    if (box.is_bounded &&
        batches[b].widest * pixels_per_unit(&args, box.least_w) < 0.5f * args.tile_size)
        return;
    const uint first = in_batches ? b * LA_BATCH : sliced(&args, i);
    const uint last = min(in_batches ? first + LA_BATCH : first + 1u, args.triangle_count);
    for (uint t = first; t < last; ++t) {
        const ScreenFace face = face_on_screen(&args, t, vertices, triangles, screen);
        if (!may_cover(&args, face)) continue;
        find_occluders(&args, t, slice, face, plane_of_face(&args, t, vertices, triangles).w,
                       vertices, triangles, screen, occluders);
    }
}

/* One work-item per slice of each triangle. planes: four numbers per triangle, see plane_of; 0 if
 * it hides nothing. states: those of the batches of the first `batched` triangles. A triangle of a
 * batch that is not seen gets FACE_UNSEEN and nothing else. */
KERNEL(surfaces_faces, ExactParameters) {
    const uint t = sliced(&args, (uint)get_global_id(0));
    const uint slice = slice_of(&args, (uint)get_global_id(0));
    if (t >= args.triangle_count || (t < args.batched && slice > 0)) return;
    if (t < args.batched && states[t / LA_BATCH] != LA_BATCH_SEEN) {
        faces[t].kind = FACE_UNSEEN;
        return;
    }
    ScreenFace face = face_on_screen(&args, t, vertices, triangles, screen);
    float4 plane = float4(0.0f, 0.0f, 0.0f, 0.0f);
    if (face.kind != FACE_UNSEEN) plane = plane_of_face(&args, t, vertices, triangles);
    if (!(plane.w > 0.0f)) face.kind = FACE_UNSEEN;
    if (slice == 0) {
        faces[t] = face;
        vstore4(plane, t, planes);
    }
    if (t >= args.batched && may_cover(&args, face))
        find_occluders(&args, t, slice, face, plane.w, vertices, triangles, screen, occluders);
}

/* The smallest distance of a triangle's corner from the opposite side. */
static float width_of(const float3 a, const float3 b, const float3 c) {
    const float3 ab = b - a, bc = c - b, ca = a - c, across = cross_product(ab, bc);
    const float longest = fmax(dot_product(ab, ab), fmax(dot_product(bc, bc), dot_product(ca, ca)));
    return longest > 0.0f ? sqrt(dot_product(across, across) / longest) : 0.0f;
}

/* batches: those of `count` triangles. */
KERNEL(surfaces_boxes, CountParameters) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * LA_BATCH;
    if (first >= args.count) return;
    const uint last = min(first + LA_BATCH, args.count);
    Box box = no_box();
    float widest = 0.0f;
    for (uint t = first; t < last; ++t) {
        add_face_to_box(&box, t, vertices, triangles);
        widest = fmax(widest, width_of(vload3(triangles[3 * t], vertices),
                                       vload3(triangles[3 * t + 1], vertices),
                                       vload3(triangles[3 * t + 2], vertices)));
    }
    vstore3(box.low, 0, batches[b].low);
    vstore3(box.high, 0, batches[b].high);
    batches[b].joined[0] = batches[b].joined[1] = 0;
    batches[b].widest = widest;
}

/* True if every tile of a box in pixels has an occluder that is nearer than `nearest` all over. */
static bool is_covered(const ExactParameters* args, const float2 low, const float2 high,
                       const float nearest, __global const uint* occluders) {
    const int2 tiles = to_int2(args->tiles);
    const float scale = 1.0f / args->tile_size;
    const int2 first = clamp(convert_int2(low * scale), int2(0, 0), tiles - 1);
    const int2 last = clamp(convert_int2(high * scale), int2(0, 0), tiles - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if (!(as_float(occluders[y * tiles.x + x]) > nearest)) return false;
        }
    }
    return true;
}

/* states: an LA_BATCH_* for each of `count` batches. A hidden batch is one that `visible` and
 * `tile_lists` would leave out piece by piece, in the same tiles. */
KERNEL(surfaces_batches, ExactParameters) {
    const uint b = (uint)get_global_id(0);
    if (b >= args.count) return;
    const float2 viewport = to_float2(args.viewport);
    const BatchOnScreen box =
        batch_on_screen(to_matrix(args.clip_from_world), viewport, batches + b);
    states[b] = box.is_outside ? LA_BATCH_OUTSIDE : LA_BATCH_SEEN;
    if (box.is_outside || !box.is_bounded || args.keeps_hidden != 0) return;
    const float nearest =
        (args.depth_rate > 0.0f ? 1.0f - box.low.z : 1.0f / box.least_w) * (1.0f + 4.0f * FEW_ULPS);
    const float2 half_size = viewport * 0.5f;
    if (is_covered(&args, (xy(box.low) + 1.0f) * half_size - BATCH_MARGIN,
                   (xy(box.high) + 1.0f) * half_size + BATCH_MARGIN, nearest, occluders))
        states[b] = LA_BATCH_HIDDEN;
}
