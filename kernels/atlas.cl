/* atlas: the visibility of every sample of every segment (§4.2, §4.3), the compute form.
 *
 * One work-item per block of `block` neighbouring samples. It finds the segment of its first sample
 * by bisection and goes on from there.
 *
 * TILED: `depth` holds only a part of the depth buffer, and only samples in its core are computed.
 *
 * PROBES_PER_AXIS: 1, 2, 3 or 4. PROBE_VECTORS 1: all probes of a sample in one vector (CPUs); 0:
 * one after the other (GPUs). */

#define PROBES (PROBES_PER_AXIS * PROBES_PER_AXIS)
#if !PROBE_VECTORS || PROBES == 1
#define LANES 1
#elif PROBES == 4
#define LANES 4
#else
#define LANES 16
#endif
#if PROBES == 9 && LANES == 16
#define LANES_IN_USE 9
#endif

#include "shared/probe.h"

/* The last segment that starts at or before sample s; it has samples. */
static uint segment_of_sample(__global const uint* offsets, const uint count, const uint s) {
    uint low = 0, high = count;
    while (high - low > 1) {
        const uint middle = low + (high - low) / 2;
        if (offsets[middle] <= s)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* How many probes see the line at sample j of l. */
static uint count_visible(const Spine spine, const uint j, const float inverse_l,
                          const Depth depth) {
    const float shift = lone_probe_shift(spine, PROBES_PER_AXIS, depth.scale);
    uint visible = 0;
    for (int first = 0; first < PROBES; first += LANES) {
        const lanes_int probe = LANE_INDEX + first;
        const lanes_int row = probe / PROBES_PER_AXIS;
        const lanes_int column = probe - row * PROBES_PER_AXIS;
        const lanes_float side = probe_side(column, row, PROBES_PER_AXIS) + shift;
        const lanes_float u = ((float)j + probe_ahead(column, row, PROBES_PER_AXIS)) * inverse_l;
        visible += (uint)COUNT(sees_line(spine, u, side, probe < PROBES, depth));
    }
    return visible;
}

#ifdef TILED
/* The place in the whole picture decides. It is the same in every tile to the last bit, so each
 * sample is in exactly one core. */
static bool is_in_core(const float2 whole_p, const Spine spine, const uint j, const float inverse_l,
                       const int4 core) {
    const float2 place = whole_p + spine.d * (((float)j + 0.5f) * inverse_l);
    const int x = convert_int_sat_rtn(place.x), y = convert_int_sat_rtn(place.y);
    return x >= core.x && y >= core.y && x < core.z && y < core.w;
}
#endif

/* alpha: one byte per sample, 0 to 255. Samples at or beyond `capacity` are left out: the host sees
 * the total, enlarges the atlas and runs the kernel again. Only TILED reads `origin`, the first
 * texel of `depth` in the whole, and `core`, the texels from xy up to but without zw. */
KERNEL(atlas, AtlasParameters) {
    const uint count = args.count;
    const uint total = min(offsets[count], args.capacity);
    const uint first = (uint)get_global_id(0) * args.block;
    if (first >= total) return;
    const uint last = min(first + args.block, total);
#ifdef TILED
    const int2 origin = to_int2(args.origin);
#else
    const int2 origin = int2(0, 0);
#endif
    const Depth buffer =
        make_depth(depth, to_int2(args.depth_size), origin, to_float2(args.viewport),
                   args.depth_scale, args.tolerance, args.surfaces, numbers, planes, patches);
    uint i = segment_of_sample(offsets, count, first);
    uint s = first;
    while (s < last) {
        const uint begin = offsets[i];
        const uint end = offsets[i + 1];
        if (end <= s) { /* the next one, unless many without samples come first */
            if (offsets[++i + 1] <= s) i = segment_of_sample(offsets, count, s);
            continue;
        }
        Spine spine = spine_of(clipped + i, to_float2(args.viewport), buffer);
        const float inverse_l = 1.0f / (float)(end - begin);
#ifdef TILED
        const float2 whole_p = spine.p;
        spine.p -= convert_float2(origin);
#endif
        const uint stop = min(end, last);
        for (; s < stop; ++s) {
#ifdef TILED
            if (!is_in_core(whole_p, spine, s - begin, inverse_l, to_int4(args.core))) continue;
#endif
            const uint visible = count_visible(spine, s - begin, inverse_l, buffer);
            alpha[s] = (uchar)((visible * 255u + PROBES / 2u) / PROBES);
        }
        ++i;
    }
}
