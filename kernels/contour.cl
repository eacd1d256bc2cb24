/* contour: silhouettes of smooth surfaces: where the normal, interpolated between the corners of a
 * triangle, is at a right angle to the view (Hertzmann and Zorin 2000). If some corners of a
 * triangle face the eye and some do not, the triangle has one segment, from edge to edge. The
 * triangle beyond each of the two edges has a segment that ends at the same place.
 *
 * A place on an edge is not on the edge's chord, which runs below the surface, but on the cubic
 * that leaves its ends at right angles to their normals (the borders of PN triangles: Vlachos et
 * al. 2001). Only at a border of the surface the place is on the chord, because the line that
 * continues the silhouette runs along the chord. A second place stands with each place, lifted off
 * the surface by more than triangles reach beyond their contour. Methods that know no surfaces test
 * the visibility of the lifted place.
 *
 * contour_turn updates the normals of objects that move, contour_normals those of objects that
 * change their shape. They run only after such a change. */

#include "kernels.h"

static float dot_of(const float3 a, const float3 b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/* How much a corner faces the eye: above 0 if it shows its front. TIP_FACING for a tip, which has
 * no normal. */
#define TIP_FACING 3.0e38f
static float facing_of(const float3 at, const float3 normal, const float4 eye) {
    if (dot_of(normal, normal) == 0.0f) return TIP_FACING;
    const float3 to_eye = xyz(eye) - at * eye.w;
    return dot_of(normal, to_eye) - LA_EDGE_ON * sqrt(dot_of(to_eye, to_eye));
}

/* How the corners of a triangle face the eye. A tip takes the value of the next corner, so that a
 * contour across the opposite side runs into the tip. Returns which corner is a tip, or 3. */
static uint facing_at(__global const uint* own, __global const float* facing, float* faces_eye) {
    const float a = facing[own[0]], b = facing[own[1]], c = facing[own[2]];
    const uint tip = a == TIP_FACING ? 0u : b == TIP_FACING ? 1u : c == TIP_FACING ? 2u : 3u;
    faces_eye[0] = tip == 0 ? b : a;
    faces_eye[1] = tip == 1 ? c : b;
    faces_eye[2] = tip == 2 ? a : c;
    return tip;
}

static float3 unit_of(const float3 v) {
    const float length = sqrt(dot_of(v, v));
    return length > 0.0f ? v / length : v;
}

static float3 across(const float3 u, const float3 v) {
    return float3(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}

static bool faces_front(const uint face, __global const uchar* front) {
    const uint flipped = (face & LA_FACE_FLIPPED) != 0 ? 1u : 0u;
    return (front[face & LA_FACE_INDEX] ^ flipped) != 0;
}

/* True if a triangle's corners run round it against its normal, as on a mirrored object. `facing`
 * takes the back of such a triangle for its front. */
static bool is_mirrored(const uint face, const float3 normal, __global const uint* triangles,
                        __global const float* vertices) {
    __global const uint* corner = triangles + 3 * (face & LA_FACE_INDEX);
    const float3 a = vload3(corner[0], vertices), b = vload3(corner[1], vertices),
                 c = vload3(corner[2], vertices);
    return dot_of(across(b - a, c - a), normal) < 0.0f;
}

/* True if its own faces hide the line along a border. Then the line is seen only up to that end of
 * the edge at which the surface shows its front. normals: the sum of the normals at both ends. */
static bool turns_away(__global const ContourEdge* edge, const float3 normals,
                       __global const uint* triangles, __global const float* vertices,
                       __global const uchar* front) {
    const bool away = is_mirrored(edge->face_a, normals, triangles, vertices);
    return faces_front(edge->face_a, front) == away &&
           (edge->face_b == LA_NO_FACE || faces_front(edge->face_b, front) == away);
}

#define QUARTER_TURN 1.57079633f

/* An angle between 0 and pi by the tangent of its half, within 2e-5 and the same on every device
 * (Abramowitz and Stegun 4.4.47). */
static float twice_arc_of(const float tangent) {
    const float t = tangent > 1.0f ? 1.0f / tangent : tangent, s = t * t;
    const float arc =
        t * ((((0.0208351f * s - 0.0851330f) * s + 0.1801410f) * s - 0.3302995f) * s + 0.9998660f);
    return 2.0f * (tangent > 1.0f ? QUARTER_TURN - arc : arc);
}

/* Makes the normals of a model anew after its shape has changed: the mean of the normals of the
 * triangles about a corner, weighted by their angles there. places: those of corner i stand from
 * offsets[i] up to offsets[i + 1]; each is a place in `triangles`. One work-item per corner. */
KERNEL(contour_normals, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    float3 sum = 0.0f;
    for (uint k = offsets[i]; k < offsets[i + 1]; ++k) {
        const uint at = places[k] % 3u, first = places[k] - at;
        const float3 a = vload3(triangles[first + at], vertices);
        const float3 u = unit_of(vload3(triangles[first + (at + 1u) % 3u], vertices) - a);
        const float3 v = unit_of(vload3(triangles[first + (at + 2u) % 3u], vertices) - a);
        const float3 normal = across(u, v);
        const float sine = sqrt(dot_of(normal, normal));
        if (sine > 0.0f) sum += normal * (twice_arc_of(sine / (1.0f + dot_of(u, v))) / sine);
    }
    vstore3(unit_of(sum), 0, corners[i].normal);
}

/* A corner's normal where its object has moved to. turns: for every object the three rows of
 * normal_turn() in host/core/objects.hpp. objects: the object of every vertex. A normal whose
 * length is right stays as it is, bit by bit. One work-item per corner. */
KERNEL(contour_turn, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const uint vertex = rest[i].vertex;
    const float3 normal = vload3(0, rest[i].normal);
    __global const float* rows = turns + 9 * objects[vertex];
    float3 turned = float3(dot_of(vload3(0, rows), normal), dot_of(vload3(1, rows), normal),
                           dot_of(vload3(2, rows), normal));
    if (fabs(dot_of(turned, turned) - 1.0f) > 1e-6f) turned = unit_of(turned);
    corners[i].vertex = vertex;
    vstore3(turned, 0, corners[i].normal);
}

/* How much every corner faces the eye, computed once for all its triangles. One work-item per
 * corner. */
KERNEL(contour_facing, ContourParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    facing[i] = facing_of(vload3(corners[i].vertex, vertices), vload3(0, corners[i].normal),
                          to_float4(args.eye));
}

/* How far a triangle's corners lie off the tangents of its surface at the other corners. That is
 * four times what an arc rises over its chord. It is more if the normals are not those of an arc,
 * as on rough triangles. */
static float rise_of(const ContourCorner* own, const float3* at) {
    float most = 0.0f;
    for (uint k = 0; k < 3; ++k) {
        const uint next = k == 2 ? 0 : k + 1;
        const float3 way = at[next] - at[k];
        most = fmax(most, fmax(fabs(dot_of(way, vload3(0, own[k].normal))),
                               fabs(dot_of(way, vload3(0, own[next].normal)))));
    }
    return most;
}

/* On undesigned surfaces a lifted contour also comes nearer to the eye, by this many longest sides
 * of its triangle. A surface so near before its own contour is only rough and does not hide it. */
#define NEARER_SIDES 0.5f
static float3 way_nearer(const float3* at, const float4 eye) {
    float longest = 0.0f;
    for (uint k = 0; k < 3; ++k) {
        const float3 side = at[k == 2 ? 0 : k + 1] - at[k];
        longest = fmax(longest, dot_of(side, side));
    }
    const float3 to_eye = xyz(eye) - (at[0] + at[1] + at[2]) * (eye.w / 3.0f);
    return unit_of(to_eye) * (NEARER_SIDES * sqrt(longest));
}

/* Writes where a contour crosses the edge between two corners that face the eye differently: the
 * place, and the same place lifted and moved on by `nearer`. edge: the triangles at a border; null:
 * the surface goes on there. */
static void put_places(const ContourCorner* from, const ContourCorner* to, const float at_a,
                       const float at_b, __global const ContourEdge* edge,
                       __global const uint* triangles, __global const uchar* front,
                       const float lift, const float3 nearer, const uint vertex,
                       __global float* vertices) {
    const float3 a = vload3(from->vertex, vertices), b = vload3(to->vertex, vertices);
    const float3 normal_a = vload3(0, from->normal), normal_b = vload3(0, to->normal);
    const float t = at_a / (at_a - at_b), s = 1.0f - t;
    const float3 way = b - a;
    const float rise_a = dot_of(way, normal_a), rise_b = dot_of(way, normal_b);
    float3 place = a + way * t;
    /* The cubic less the chord. Its inner control points are moved by a third of the rises. */
    if (edge == 0)
        place += (normal_b * (rise_b * t) - normal_a * (rise_a * s)) * (s * t);
    else if (turns_away(edge, normal_a + normal_b, triangles, vertices, front))
        place = at_a >= 0.0f ? a : b;
    const float3 normal = unit_of(normal_a * s + normal_b * t);
    vstore3(place, vertex, vertices);
    vstore3(place + normal * lift + nearer, vertex + 1, vertices);
}

/* Writes the tip that a contour runs into. The tip is not lifted, because the contour ends there.
 */
static void put_tip(const float3 place, const uint vertex, __global float* vertices) {
    vstore3(place, vertex, vertices);
    vstore3(place, vertex + 1, vertices);
}

/* True if the surface turns its front away from the eye where it comes nearer along the triangle:
 * its radial curvature is negative (Koenderink 1984, "What does the occluding contour tell us about
 * solid shape?"). Such a contour is seen from the back; on a solid it is not seen at all. corners:
 * how much each corner faces the eye. tip: which corner is a tip. */
static bool shows_back(const float3* at, const float* corners, const uint tip, const float4 eye) {
    /* Facing is constant along lines to a tip. */
    float facing[3];
    for (uint k = 0; k < 3; ++k)
        facing[k] = k == tip ? 0.5f * (corners[k == 0 ? 2 : k - 1] + corners[k == 2 ? 0 : k + 1])
                             : corners[k];
    const float3 u = at[1] - at[0], v = at[2] - at[0];
    const float3 to_eye = xyz(eye) - (at[0] + at[1] + at[2]) * (eye.w / 3.0f);
    const float uu = dot_of(u, u), uv = dot_of(u, v), vv = dot_of(v, v);
    const float along_u = dot_of(to_eye, u), along_v = dot_of(to_eye, v);
    return (facing[1] - facing[0]) * (along_u * vv - along_v * uv) +
               (facing[2] - facing[0]) * (along_v * uu - along_u * uv) <
           0.0f;
}

/* numbers: for each triangle 1 if a contour crosses it, else 0. They stand behind the numbers of
 * other candidates. face_corners: three per triangle. One work-item per triangle. */
KERNEL(contour_cross, ContourParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    float own[3];
    facing_at(face_corners + 3 * i, facing, own);
    const uint fronts =
        (own[0] >= 0.0f ? 1u : 0u) + (own[1] >= 0.0f ? 1u : 0u) + (own[2] >= 0.0f ? 1u : 0u);
    numbers[args.first_number + i] = fronts == 1 || fronts == 2 ? 1u : 0u;
}

/* Finds where contours cross triangles. Of the two triangles beside an edge, the one that the edge
 * runs with finds the place on it. numbers: those of `silhouette`. One work-item per silhouette. */
KERNEL(contour_places, ContourParameters) {
    const uint n = (uint)get_global_id(0);
    if (n >= args.count || chosen[n] < args.contours || chosen[n] == LA_NO_SILHOUETTE) return;
    const uint i = chosen[n] - args.contours;
    const ContourFace face = faces[i];
    float faces_eye[3];
    const uint tip = facing_at(face_corners + 3 * i, facing, faces_eye);
    ContourCorner own[3];
    float3 at[3];
    for (uint k = 0; k < 3; ++k) {
        own[k] = corners[face_corners[3 * i + k]];
        at[k] = vload3(own[k].vertex, vertices);
    }
    ContourCrossing crossing;
    bool lacks_place = false;
    const float lift = LA_CONTOUR_LIFT * rise_of(own, at);
    crossing.underside = shows_back(at, faces_eye, tip, to_float4(args.eye)) ? 1 : 0;
    float3 nearer = 0.0f;
    if ((segments[args.first + chosen[n]].tag & LA_TAG_UNDESIGNED) != 0)
        nearer = way_nearer(at, to_float4(args.eye));
    /* `visible` lifts such a contour to the other side. */
    if (crossing.underside != 0 && args.on_surface != 0) nearer = nearer * -1.0f;
    for (uint k = 0; k < 3; ++k) {
        const uint next = k == 2 ? 0 : k + 1;
        const bool falls = faces_eye[k] >= 0.0f; /* this crossing is p here, and q of the triangle
                                                    beyond the edge */
        if (falls == (faces_eye[next] >= 0.0f)) continue;
        const bool at_tip = k == tip || next == tip;
        const uint across = at_tip ? LA_NO_FACE : face.across[k];
        const uint other =
            across == LA_NO_FACE ? LA_NO_SILHOUETTE : numbers[args.first_number + across];
        uint vertex = args.first_vertex + 4 * n + (falls ? 0u : 2u);
        if (at_tip)
            put_tip(k == tip ? at[k] : at[next], vertex, vertices);
        else if ((face.edges[k] & LA_CONTOUR_TURNED) != 0) {
            lacks_place = lacks_place || other >= args.count;
            vertex = args.first_vertex + 4 * min(other, args.count - 1u) + (falls ? 2u : 0u);
        } else
            put_places(own + k, own + next, faces_eye[k], faces_eye[next],
                       across == LA_NO_FACE ? edges + face.edges[k] : 0, triangles, front, lift,
                       nearer, vertex, vertices);
        if (falls) {
            crossing.p = vertex;
            crossing.before = other;
        } else {
            crossing.q = vertex;
            crossing.after = other;
        }
    }
    /* There is no room for the silhouette that has the place. Nothing is drawn then. */
    if (lacks_place) crossing.p = crossing.q = 0;
    crossings[n] = crossing;
}
