/* pyramid: the farthest depth in every tile of the depth buffer. A segment that lies behind that
 * depth in all tiles that it touches is hidden, so `project_clip` can drop the segment before it
 * gets samples (Greene et al. 1993).
 *
 * One work-item per tile of LA_TILE by LA_TILE texels. */

#define LANES LA_TILE
#include "kernels.h"
#include "shared/lanes.h"

/* tiles: ceil(width / LA_TILE) per row, rows from the lower left like depth. */
KERNEL(pyramid, PyramidParameters) {
    const int2 depth_size = to_int2(args.depth_size), tile_count = to_int2(args.tile_count);
    const int i = (int)get_global_id(0);
    if (i >= tile_count.x * tile_count.y) return;
    const int x = i % tile_count.x * LA_TILE;
    const int y = i / tile_count.x * LA_TILE;
    const int rows = min(LA_TILE, depth_size.y - y);
    float farthest = 0.0f;
    if (x + LA_TILE <= depth_size.x) {
        lanes_float row_farthest = LOAD_LANES(depth + y * depth_size.x + x);
        for (int row = 1; row < rows; ++row) {
            row_farthest = max(row_farthest, LOAD_LANES(depth + (y + row) * depth_size.x + x));
        }
        farthest = LARGEST(row_farthest);
    } else {
        for (int row = 0; row < rows; ++row) {
            for (int column = x; column < depth_size.x; ++column) {
                farthest = fmax(farthest, depth[(y + row) * depth_size.x + column]);
            }
        }
    }
    tiles[i] = farthest;
}
