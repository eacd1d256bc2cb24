/* The box of a cluster of triangles on the screen: what `cull` and `depth` ask before they look at
 * the triangles. */
#ifndef LINEATLAS_SCREEN_BOX_H
#define LINEATLAS_SCREEN_BOX_H

#include "kernels.h"
#include "shared/clipping.h"

typedef struct ScreenBox {
    float3 low, high; /* normalised device coordinates; no bounds if before_near */
    bool is_outside;  /* all corners lie beyond one plane of the frustum */
    bool before_near; /* a corner lies before the near plane */
} ScreenBox;

static ScreenBox box_on_screen(const Matrix m, __global const Cluster* cluster) {
    const float3 low = vload3(0, cluster->low);
    const float3 high = vload3(0, cluster->high);
    ScreenBox box;
    box.low = INFINITY;
    box.high = -INFINITY;
    box.before_near = false;
    int outside = 63; /* planes that all corners so far lie outside of */
    for (int corner = 0; corner < 8; ++corner) {
        const float4 c = transform_point(m, float3((corner & 1) != 0 ? high.x : low.x,
                                                   (corner & 2) != 0 ? high.y : low.y,
                                                   (corner & 4) != 0 ? high.z : low.z));
        outside &= (c.x < -c.w ? 1 : 0) | (c.x > c.w ? 2 : 0) | (c.y < -c.w ? 4 : 0) |
                   (c.y > c.w ? 8 : 0) | (c.z < -c.w ? 16 : 0) | (c.z > c.w ? 32 : 0);
        box.before_near = box.before_near || c.z < -c.w || c.w <= 0.0f;
        const float3 n = xyz(c) / c.w;
        box.low = fmin(box.low, n);
        box.high = fmax(box.high, n);
    }
    box.is_outside = outside != 0;
    return box;
}

/* True if every tile under a rectangle of texels is nearer all over than `nearest`. */
static bool tiles_hide(const float2 low, const float2 high, const float nearest,
                       __global const float* tiles, const int2 tile_count) {
    /* Towards zero, as in is_hidden(). */
    const int2 first = clamp(convert_int2(low * (1.0f / LA_TILE)), int2(0, 0), tile_count - 1);
    const int2 last = clamp(convert_int2(high * (1.0f / LA_TILE)), int2(0, 0), tile_count - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if (tiles[y * tile_count.x + x] >= nearest) return false;
        }
    }
    return true;
}

#endif
