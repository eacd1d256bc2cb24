/* Looking at the depth buffer along a segment: what `atlas` and `intervals` share, once each.
 * LANES: how many probes are made at once, see lanes.h. */
#include "kernels.h"
#include "lanes.h"

/* The depth buffer, and how much may stand before a line: in window depth times w. */
typedef struct Depth {
    __global const float* texels;
    int2 size;
    float scale; /* texels per pixel */
    float tolerance;
} Depth;

static lanes_float depth_at(const Depth depths, const lanes_int column, const lanes_int row) {
    const lanes_int index = row * depths.size.x + column;
    return GATHER_LANES(depths.texels, index);
}

#include "spine.h"

static Spine spine_of(__global const ClippedSegment* segment, const float2 viewport,
                      const float depth_scale) {
    return make_spine(vload4(0, segment->p), vload4(0, segment->q), segment->own_a, segment->own_b,
                      viewport, depth_scale);
}
