/* planes: the plane of every triangle as the screen sees it, for probes that know surfaces.
 *
 * On the screen the nearness of a plane (1/w, or 1 - z of a parallel view: what grows towards the
 * eye) is linear. One work-item per cluster of triangles, so that vertices are fetched once.
 *
 * DEPTH_LANES: triangles at once, 1 on GPUs. */

#define LANES DEPTH_LANES
#include "kernels.h"
#include "lanes.h"

/* Planes flatter to the eye than this (sine) are seen from the edge: they hide nothing. */
#define SEEN_FROM_THE_EDGE 1e-6f

typedef struct Vector {
    lanes_float x, y, z;
} Vector;

static Vector difference(const Vector a, const Vector b) {
    const Vector d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return d;
}

static lanes_float dot_of(const Vector a, const Vector b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

static Vector chosen(const Vector a, const Vector b, const lanes_mask second) {
    const Vector v = {SELECT(a.x, b.x, second), SELECT(a.y, b.y, second), SELECT(a.z, b.z, second)};
    return v;
}

/* Normal to the triangle. Of two of its edges the product is taken that loses least: the shorter
 * two. */
static Vector normal_of(const Vector a, const Vector b, const Vector c) {
    const Vector ab = difference(b, a), bc = difference(c, b), ca = difference(a, c);
    const lanes_float ab2 = dot_of(ab, ab), bc2 = dot_of(bc, bc), ca2 = dot_of(ca, ca);
    const lanes_mask without_ab = (ab2 >= bc2) & (ab2 >= ca2);
    const lanes_mask without_bc = bc2 >= ca2;
    /* The pairs follow each other around the triangle. */
    const Vector u = chosen(chosen(ab, ca, without_bc), bc, without_ab);
    const Vector v = chosen(chosen(bc, ab, without_bc), ca, without_ab);
    const Vector n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    return n;
}

/* From point a to what a column of world_from_screen stands for: a point, or a direction. */
static Vector way_to(const float4 column, const Vector a) {
    const Vector v = {column.x - a.x * column.w, column.y - a.y * column.w,
                      column.z - a.z * column.w};
    return v;
}

/* The vertices of a meshlet. */
typedef struct Corners {
    float x[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
    float y[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
    float z[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
} Corners;

static Vector corner_at(const Corners* corners, const lanes_int at) {
    const Vector v = {GATHER_LANES(corners->x, at), GATHER_LANES(corners->y, at),
                      GATHER_LANES(corners->z, at)};
    return v;
}

/* planes: four numbers a triangle: its nearness at place (x, y) on the screen is the first times x,
 * the second times y and the third; the fourth, times 1/w of a point, is the difference of nearness
 * up to which the point touches the plane. What cannot be told is touched by everything. */
KERNEL(planes, PlanesParameters) {
    const uint cluster = (uint)get_global_id(0);
    if (cluster >= args.count) return;
    if (args.only_seen != 0 && seen[cluster] == 0) return;
    const Matrix m = to_matrix(args.world_from_screen);
    const Meshlet meshlet = meshlets[cluster];
    __global const uint* list = vertex_list + meshlet.vertices;
    Corners places;
    for (uint i = 0; i < meshlet.vertex_count; ++i) {
        const float3 v = vload3(list[i], vertices);
        places.x[i] = v.x;
        places.y[i] = v.y;
        places.z[i] = v.z;
    }
    const uint row =
        (meshlet.triangle_count + LA_MESHLET_PADDING - 1u) & ~(LA_MESHLET_PADDING - 1u);
    __global float* out = planes + 4u * (size_t)clusters[cluster].first;
    for (uint first = 0; first < meshlet.triangle_count; first += LANES) {
        __global const uchar* own = corners + meshlet.corners + first;
        const Vector a = corner_at(&places, LOAD_BYTES(own));
        const Vector b = corner_at(&places, LOAD_BYTES(own + row));
        const Vector c = corner_at(&places, LOAD_BYTES(own + 2u * row));
        const Vector n = normal_of(a, b, c);
        const Vector to_near = way_to(m.w, a);
        const lanes_float rise = dot_of(n, to_near);
        const lanes_float none = 0.0f, one = 1.0f, all = INFINITY;
        const lanes_float flat = SEEN_FROM_THE_EDGE * SEEN_FROM_THE_EDGE;
        const lanes_float n2 = dot_of(n, n);
        const lanes_mask told = rise * rise > flat * (n2 * dot_of(to_near, to_near));
        const lanes_float inverse = -one / SELECT(one, rise, told);
        float part[4][LANES];
        STORE_LANES(SELECT(none, dot_of(n, way_to(m.x, a)) * inverse, told), part[0]);
        STORE_LANES(SELECT(none, dot_of(n, way_to(m.y, a)) * inverse, told), part[1]);
        STORE_LANES(SELECT(none, dot_of(n, way_to(m.z, a)) * inverse, told), part[2]);
        STORE_LANES(SELECT(all, fabs(inverse) * SQUARE_ROOT(n2) * args.contact, told), part[3]);
        const uint end = min((uint)LANES, meshlet.triangle_count - first);
        for (uint i = 0; i < end; ++i) {
            for (uint k = 0; k < 4u; ++k) out[4u * (first + i) + k] = part[k][i];
        }
    }
}
