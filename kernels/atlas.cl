/* atlas: the visibility of every sample of every segment (§4.2, §4.3), the compute form.
 *
 * One work-item per block of `block` neighbouring samples: it finds the segment of its first sample
 * by bisection and walks on from there.
 *
 * TILED: `depth` holds only a part of the depth buffer, and only samples in its core are computed.
 *
 * PROBES_PER_AXIS: 1, 2, 3 or 4. PROBE_LANES: 1 probes one after the other (GPUs), 4 or 16 all
 * probes of a sample in one vector (CPUs); at least the number of probes then. */

#pragma OPENCL FP_CONTRACT OFF

#if !defined(PROBES_PER_AXIS) || !defined(PROBE_LANES)
#error "PROBES_PER_AXIS and PROBE_LANES must be set"
#endif
#define PROBES (PROBES_PER_AXIS * PROBES_PER_AXIS)

#include "atlas_address.h"
#include "probe.h"
#include "segment_table.h"

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

/* How many probes see sample j. They fill a box one pixel wide across the line and one sample long
 * along it (§3.2, §4.3), each row and column of them a little further along than the one before, so
 * that no two are at the same place along or across the line. A single probe on a smooth silhouette
 * would hit the surface or miss it by chance, and the outline would be dashed; it stands outside
 * instead. */
static uint count_visible(const Spine spine, const uint j, const Depth depth) {
    const float shift =
        PROBES_PER_AXIS == 1 ? spine.outside * LA_FOLD_CLEARANCE * (1.0f / depth.scale) : 0.0f;
    const float middle = 0.5f * (PROBES_PER_AXIS - 1);
    uint visible = 0;
    for (int first = 0; first < PROBES; first += PROBE_LANES) {
        const lanes_int probe = LANE_INDEX + first;
        const lanes_int row = probe / PROBES_PER_AXIS;
        const lanes_int column = probe - row * PROBES_PER_AXIS;
        const lanes_float row_shift = (TO_FLOAT(column) - middle) * (1.0f / PROBES);
        const lanes_float column_shift = (TO_FLOAT(row) - middle) * (1.0f / PROBES);
        const lanes_float row_place = (TO_FLOAT(row) + 0.5f) * (1.0f / PROBES_PER_AXIS) + row_shift;
        const lanes_float side =
            (TO_FLOAT(column) + 0.5f) * (1.0f / PROBES_PER_AXIS) - 0.5f + column_shift + shift;
        const lanes_float u = ((float)j + row_place) * spine.inverse_l;
        visible += (uint)COUNT(sees_line(spine, u, side, probe < PROBES, depth));
    }
    return visible;
}

#ifdef TILED
/* Judged by the place in the whole picture, which is the same in every tile to the last bit: so
 * each sample is in exactly one core. */
static bool is_in_core(const float2 whole_p, const Spine spine, const uint j, const int4 core) {
    const float2 place = whole_p + spine.d * (((float)j + 0.5f) * spine.inverse_l);
    const int x = convert_int_sat_rtn(place.x), y = convert_int_sat_rtn(place.y);
    return x >= core.x && y >= core.y && x < core.z && y < core.w;
}
#endif

/* alpha: one byte per sample at its atlas address, 0 to 255. Samples at or beyond `capacity` are
 * left out: the host sees the total, enlarges the atlas and runs the kernel again. For TILED alone:
 * origin is the first texel of `depth` in the whole, core the texels from xy up to zw, without. */
__kernel void atlas(__global const ClippedSegment* restrict clipped,
                    __global const uint* restrict offsets, const uint count,
                    __global const float* restrict depth, const int2 depth_size,
                    const float2 viewport, const float depth_scale, const float tolerance,
                    const uint width, const uint pitch, const uint capacity, const uint block,
                    const int2 origin, const int4 core, __global uchar* restrict alpha) {
    const uint total = min(offsets[count], capacity);
    const uint first = (uint)get_global_id(0) * block;
    if (first >= total) return;
    const uint last = min(first + block, total);
    const Depth buffer = {depth, depth_size, depth_scale, tolerance};
    uint i = segment_of_sample(offsets, count, first);
    uint s = first;
    while (s < last) {
        const uint begin = offsets[i];
        const uint end = offsets[i + 1];
        if (end <= s) { /* the next one, unless many without samples come first */
            if (offsets[++i + 1] <= s) i = segment_of_sample(offsets, count, s);
            continue;
        }
        Spine spine = make_spine(clipped + i, viewport, depth_scale, end - begin);
#ifdef TILED
        const float2 whole_p = spine.p;
        spine.p -= convert_float2(origin);
#endif
        const uint address = atlas_address(begin, width, pitch);
        const uint stop = min(end, last);
        for (; s < stop; ++s) {
#ifdef TILED
            if (!is_in_core(whole_p, spine, s - begin, core)) continue;
#endif
            const uint visible = count_visible(spine, s - begin, buffer);
            alpha[address + s - begin] = (uchar)((visible * 255u + PROBES / 2u) / PROBES);
        }
        ++i;
    }
}
