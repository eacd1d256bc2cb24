/* Looking at the depth buffer along a segment, for `atlas` and `intervals`, which include this file
 * once each. LANES: how many probes are made at once, see lanes.h. */
#include "kernels.h"
#include "shared/lanes.h"

/* The depth buffer, and how much may stand before a line: in window depth times w. */
typedef struct Depth {
    __global const float* texels;
    int2 size;
    float scale; /* texels per pixel */
    float tolerance;
    /* Whether `planes` and the numbered form of `depth` have run, and what follows from the view.
     */
    bool knows_surfaces, parallel;
    float bend;
    float2 screen_scale, screen_origin; /* from texels to places on the screen, -1 to 1 */
    __global const uint* numbers;
    __global const float* planes;
    __global const uint* patches;
} Depth;

/* origin: the place of the first texel in the whole depth buffer. */
static Depth make_depth(__global const float* texels, const int2 size, const int2 origin,
                        const float2 viewport, const float scale, const float tolerance,
                        const SurfaceParameters surfaces, __global const uint* numbers,
                        __global const float* planes, __global const uint* patches) {
    Depth depths;
    depths.texels = texels;
    depths.size = size;
    depths.scale = scale;
    depths.tolerance = tolerance;
    depths.knows_surfaces = surfaces.known != 0;
    depths.parallel = surfaces.parallel != 0;
    depths.bend = surfaces.bend;
    depths.screen_scale = float2(2.0f, 2.0f) / (viewport * scale);
    depths.screen_origin = convert_float2(origin) * depths.screen_scale - 1.0f;
    depths.numbers = numbers;
    depths.planes = planes;
    depths.patches = patches;
    return depths;
}

static lanes_int number_at(const Depth depths, const lanes_int column, const lanes_int row) {
    const lanes_int index = row * depths.size.x + column;
    return GATHER_INTS(depths.numbers, index);
}

static lanes_float plane_at(const Depth depths, const lanes_int number, const int part) {
    const lanes_int index = number * 4 + part;
    return GATHER_LANES(depths.planes, index);
}

static lanes_int patch_at(const Depth depths, const lanes_int number) {
    return GATHER_INTS(depths.patches, number);
}

static lanes_float depth_at(const Depth depths, const lanes_int column, const lanes_int row) {
    const lanes_int index = row * depths.size.x + column;
    return GATHER_LANES(depths.texels, index);
}

#include "shared/spine.h"

static int own_patch(const Depth depths, const int number) {
    return number != (int)LA_NO_NUMBER ? (int)depths.patches[number] : LA_NO_PATCH;
}

static Spine spine_of(__global const ClippedSegment* segment, const float2 viewport,
                      const Depth depths) {
    Spine spine = make_spine(vload4(0, segment->p), vload4(0, segment->q), segment->own_a,
                             segment->own_b, depths.knows_surfaces, viewport, depths.scale);
    if (depths.knows_surfaces) {
        spine.patch_a = own_patch(depths, spine.number_a);
        spine.patch_b = own_patch(depths, spine.number_b);
    }
    return spine;
}
