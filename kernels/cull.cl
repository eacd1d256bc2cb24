/* cull: which clusters of triangles may be visible: those inside the frustum and not behind the
 * depth pyramid.
 *
 * One work-item per cluster. A cluster that is left out would not change a single depth value,
 * because all of its box lies behind the depth that was drawn before (Greene et al. 1993). */

#include "kernels.h"
#include "shared/screen_box.h"

/* visible[i]: 1 if cluster i may be seen, else 0. */
KERNEL(cull, CullParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const ScreenBox box = box_on_screen(to_matrix(args.clip_from_world), &clusters[i]);
    if (box.is_outside) {
        visible[i] = 0;
        return;
    }
    if (box.before_near) { /* the corners of the box do not bound it on the screen */
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
