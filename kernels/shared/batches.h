/* Batches of segments or triangles: what `project_clip` and `surfaces` share to look at them. */
#ifndef LINEATLAS_BATCHES_H
#define LINEATLAS_BATCHES_H

#include "kernels.h"
#include "shared/clipping.h"

/* Rounding of a point in clip space, with some to spare, as a share of the largest sum that the
 * point is made of. The box of a batch is wider by it. */
#define BATCH_ROUNDING 1e-6f
/* A batch counts as outside only if it is at least this far from the picture, in pixels. */
#define BATCH_MARGIN 2.0f
/* A box that reaches beyond this, in normalised device coordinates, counts as unbounded: floats end
 * somewhere. */
#define BATCH_LARGEST 1e4f

/* A batch in normalised device coordinates. */
typedef struct BatchOnScreen {
    float3 low, high; /* mean nothing unless is_bounded */
    float least_w;
    bool is_outside; /* beside the picture, or before the near plane */
    bool is_bounded; /* all of it lies beyond the near plane */
} BatchOnScreen;

static float largest_of(const float x, const float y, const float z, const float w) {
    return (fabs(x) + fabs(y)) + (fabs(z) + fabs(w));
}

static BatchOnScreen batch_on_screen(const Matrix m, const float2 viewport,
                                     __global const Batch* batch) {
    const float3 low = vload3(0, batch->low), high = vload3(0, batch->high);
    const float3 farthest = fmax(high, low * -1.0f);
    /* The rounding of each coordinate, from the largest sums that it is made of at any corner. */
    const float3 e =
        float3(largest_of(m.x.x * farthest.x, m.y.x * farthest.y, m.z.x * farthest.z, m.w.x),
               largest_of(m.x.y * farthest.x, m.y.y * farthest.y, m.z.y * farthest.z, m.w.y),
               largest_of(m.x.z * farthest.x, m.y.z * farthest.y, m.z.z * farthest.z, m.w.z)) *
        BATCH_ROUNDING;
    const float e_w =
        largest_of(m.x.w * farthest.x, m.y.w * farthest.y, m.z.w * farthest.z, m.w.w) *
        BATCH_ROUNDING;
    const float2 wide = BATCH_MARGIN * 2.0f / viewport + 1.0f;
    BatchOnScreen box;
    box.low = float3(INFINITY, INFINITY, INFINITY);
    box.high = float3(-INFINITY, -INFINITY, -INFINITY);
    box.least_w = INFINITY;
    box.is_bounded = true;
    uint outside = 31u; /* planes that all corners so far lie outside of */
    for (uint corner = 0; corner < 8; ++corner) {
        const float4 c = transform_point(m, float3((corner & 1u) != 0 ? high.x : low.x,
                                                   (corner & 2u) != 0 ? high.y : low.y,
                                                   (corner & 4u) != 0 ? high.z : low.z));
        const float w_x = c.w * wide.x + 2.0f * e_w, w_y = c.w * wide.y + 2.0f * e_w;
        outside &= (c.x + e.x < -w_x ? 1u : 0u) | (c.x - e.x > w_x ? 2u : 0u) |
                   (c.y + e.y < -w_y ? 4u : 0u) | (c.y - e.y > w_y ? 8u : 0u) |
                   (c.z + e.z < -(c.w + e_w) ? 16u : 0u);
        const float w = c.w - e_w; /* a nearer place is larger on the screen */
        box.is_bounded = box.is_bounded && w > 0.0f && c.z - e.z > -w;
        const float3 n = xyz(c) / c.w;
        const float3 doubt = (e + fmax(n, n * -1.0f) * e_w) / w;
        box.low = fmin(box.low, n - doubt);
        box.high = fmax(box.high, n + doubt);
        box.least_w = fmin(box.least_w, w);
    }
    box.is_outside = outside != 0u;
    const float3 size = fmax(box.high, box.low * -1.0f);
    box.is_bounded = box.is_bounded && size.x < BATCH_LARGEST && size.y < BATCH_LARGEST &&
                     size.z < BATCH_LARGEST;
    return box;
}

/* The box around what is added to it. */
typedef struct Box {
    float3 low, high;
} Box;

static Box no_box(void) {
    Box box;
    box.low = float3(INFINITY, INFINITY, INFINITY);
    box.high = float3(-INFINITY, -INFINITY, -INFINITY);
    return box;
}

static void add_to_box(Box* box, const float3 point) {
    box->low = fmin(box->low, point);
    box->high = fmax(box->high, point);
}

static void add_face_to_box(Box* box, const uint face, __global const float* vertices,
                            __global const uint* triangles) {
    for (uint k = 0; k < 3; ++k) add_to_box(box, vload3(triangles[3 * face + k], vertices));
}

#endif
