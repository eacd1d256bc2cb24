/* pyramid: the farthest depth in every tile of the depth buffer. What lies behind it everywhere is
 * hidden, so that `project_clip` can drop hidden segments before they get samples (Greene et al.
 * 1993).
 *
 * One work-item per tile of LA_TILE by LA_TILE texels. */

#include "segment_table.h"

/* tiles: ceil(width / LA_TILE) per row, rows from the lower left like depth. */
__kernel void pyramid(__global const float* restrict depth, const int2 depth_size,
                      const int2 tile_count, __global float* restrict tiles) {
    const int i = (int)get_global_id(0);
    if (i >= tile_count.x * tile_count.y) return;
    const int x = i % tile_count.x * LA_TILE;
    const int y = i / tile_count.x * LA_TILE;
    const int rows = min(LA_TILE, depth_size.y - y);
    float farthest = 0.0f;
    if (x + LA_TILE <= depth_size.x) {
        float16 row_farthest = 0.0f;
        for (int row = 0; row < rows; ++row) {
            row_farthest = fmax(row_farthest, vload16(0, depth + (y + row) * depth_size.x + x));
        }
        const float8 eight = fmax(row_farthest.lo, row_farthest.hi);
        const float4 four = fmax(eight.lo, eight.hi);
        farthest = fmax(fmax(four.x, four.y), fmax(four.z, four.w));
    } else {
        for (int row = 0; row < rows; ++row) {
            for (int column = x; column < depth_size.x; ++column) {
                farthest = fmax(farthest, depth[(y + row) * depth_size.x + column]);
            }
        }
    }
    tiles[i] = farthest;
}
