/* cull: which clusters of triangles may be seen: inside the frustum, and not behind the depth
 * pyramid.
 *
 * One work-item per cluster. A cluster that is left out would not change a single depth value: all
 * of its box lies behind everything that is there already (Greene et al. 1993). */

#include "kernels.h"
#include "screen_box.h"

/* Whether the tiles under a rectangle of texels hold nothing as far away as `nearest`. */
static bool tiles_hide(const float2 low, const float2 high, const float nearest,
                       __global const float* tiles, const int2 tile_count) {
    const int2 first = clamp(convert_int2_rtn(low * (1.0f / LA_TILE)), int2(0, 0), tile_count - 1);
    const int2 last = clamp(convert_int2_rtn(high * (1.0f / LA_TILE)), int2(0, 0), tile_count - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if (tiles[y * tile_count.x + x] >= nearest) return false;
        }
    }
    return true;
}

/* visible[i]: 1 if cluster i may be seen, else 0. */
KERNEL(cull, CullParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const ScreenBox box = box_on_screen(to_matrix(args.clip_from_world), &clusters[i]);
    if (box.is_outside) {
        visible[i] = 0;
        return;
    }
    if (box.before_near) { /* its corners don't bound it on the screen */
        visible[i] = 1;
        return;
    }
    const float2 size = convert_float2(to_int2(args.depth_size));
    /* One texel to spare for the rasteriser's grid. */
    const float2 first = (xy(box.low) * 0.5f + 0.5f) * size - 1.0f;
    const float2 last = (xy(box.high) * 0.5f + 0.5f) * size + 1.0f;
    const float nearest = box.low.z * 0.5f + 0.5f - 4.0f * LA_DEPTH_ROUNDING;
    visible[i] = tiles_hide(first, last, nearest, tiles, to_int2(args.tile_count)) ? 0 : 1;
}
