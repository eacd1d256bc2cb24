/* planes: the plane of every triangle in screen coordinates, for probes that know surfaces.
 *
 * On the screen the nearness of a plane (1/w, or 1 - z in a parallel view; it grows towards the
 * eye) is linear. One work-item per cluster of triangles, so that vertices are fetched once.
 *
 * DEPTH_LANES: triangles at once, 1 on GPUs. */

#define LANES DEPTH_LANES
#include "kernels.h"
#include "shared/lanes.h"
#include "shared/meshlet_faces.h"

/* Planes flatter to the eye than this (sine) are seen from the edge: they hide nothing. */
#define SEEN_FROM_THE_EDGE 1e-6f

/* The way from point a to the point that a column of world_from_screen stands for, or the direction
 * that it stands for. */
static Vector way_to(const float4 column, const Vector a) {
    const Vector v = {column.x - a.x * column.w, column.y - a.y * column.w,
                      column.z - a.z * column.w};
    return v;
}

/* planes: four numbers per triangle. Its nearness at place (x, y) on the screen is the first number
 * times x, plus the second times y, plus the third. The fourth, times 1/w of a point, is the
 * difference of nearness up to which the point touches the plane. Everything touches a plane that
 * cannot be computed. */
KERNEL(planes, PlanesParameters) {
    const uint cluster = (uint)get_global_id(0);
    if (cluster >= args.count) return;
    if (args.only_seen != 0 && seen[cluster] == 0) return;
    const Matrix m = to_matrix(args.world_from_screen);
    const Meshlet meshlet = meshlets[cluster];
    Corners places;
    load_corners(&places, vertex_list + meshlet.vertices, meshlet.vertex_count, vertices);
    const uint row = row_of(meshlet);
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
