/* transform: moves the objects of a model by a matrix each (§4.1). Runs only in frames after a
 * change.
 *
 * transform moves the vertices, transform_boxes the boxes of the clusters. transform_bounds makes
 * these boxes anew if the shape of the model has changed. transform_forget marks lines that
 * `temporal` must not average.
 */

#include "kernels.h"

/* A row of an object's affine matrix, world from object. Products with 0 and 1 are exact, so an
 * object that has not moved keeps its place bit by bit. */
static float moved(__global const float* row, const float3 v) {
    return (row[0] * v.x + row[1] * v.y) + (row[2] * v.z + row[3]);
}

/* matrices: three rows of four for every object. vertices and drawn hold the same positions, one
 * for kernels and one for GL, which read at the same time. One work-item per vertex. */
KERNEL(transform, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const float3 v = vload3(i, rest);
    __global const float* m = matrices + 12 * objects[i];
    const float3 at = float3(moved(m, v), moved(m + 4, v), moved(m + 8, v));
    vstore3(at, i, vertices);
    vstore3(at, i, drawn);
}

/* One axis of a box around a moved box: the middle moves, and half its size grows with the row. The
 * result is a little larger, so that vertices that are rounded differently lie inside too. */
static float2 moved_extent(__global const float* row, const float3 middle, const float3 half_size) {
    const float at = moved(row, middle);
    const float reach =
        (fabs(row[0]) * half_size.x + fabs(row[1]) * half_size.y) + fabs(row[2]) * half_size.z;
    const float size = (fabs(row[0] * middle.x) + fabs(row[1] * middle.y)) +
                       (fabs(row[2] * middle.z) + fabs(row[3]));
    const float most = reach + LA_BOX_ROUNDING * (reach + size);
    return float2(at - most, at + most);
}

/* The box around every cluster's moved box. objects: the object that each cluster lies in. */
KERNEL(transform_boxes, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const float3 low = vload3(0, rest[i].low), high = vload3(0, rest[i].high);
    const float3 middle = (low + high) * 0.5f, half_size = (high - low) * 0.5f;
    __global const float* m = matrices + 12 * objects[i];
    for (int axis = 0; axis < 3; ++axis) {
        const float2 extent = moved_extent(m + 4 * axis, middle, half_size);
        clusters[i].low[axis] = extent.x;
        clusters[i].high[axis] = extent.y;
    }
    clusters[i].first = rest[i].first;
    clusters[i].count = rest[i].count;
}

/* The boxes of clusters from their vertices. Empty clusters keep their boxes. triangles: in the
 * order of the clusters. */
KERNEL(transform_bounds, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || clusters[i].count == 0) return;
    const uint first = 3 * clusters[i].first, last = first + 3 * clusters[i].count;
    float3 low = INFINITY, high = -INFINITY;
    for (uint k = first; k < last; ++k) {
        const float3 v = vload3(triangles[k], vertices);
        low = fmin(low, v);
        high = fmax(high, v);
    }
    vstore3(low, 0, clusters[i].low);
    vstore3(high, 0, clusters[i].high);
}

/* ranges: those of `temporal`. Segments of jumped objects get empty ranges, so that none of their
 * samples is found in the frame before. One work-item per segment. */
KERNEL(transform_forget, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    if (jumped[objects[segments[i].p]] != 0) ranges[i] = 0;
}
