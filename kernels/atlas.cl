/* atlas: the visibility of every sample of every segment (§4.2, §4.3), the compute form.
 *
 * One work-item per block of `block` neighbouring samples: it finds the segment of its first sample by
 * bisection and walks on from there. */

#include "segment_table.h"

#pragma OPENCL FP_CONTRACT OFF

/* Eq. 2, as an index into rows of `pitch` texels of which the first `width` can start a segment:
 * wrapped if width equals pitch, else with a gutter. Sample j of a segment is at the segment's
 * address + j. */
static uint atlas_address(const uint s, const uint width, const uint pitch) {
    return s / width * pitch + s % width;
}

/* The last segment that starts at or before sample s; it has samples. */
static uint segment_of_sample(__global const uint* offsets, const uint count, const uint s) {
    uint low = 0, high = count;
    while (high - low > 1) {
        const uint middle = low + (high - low) / 2;
        if (offsets[middle] <= s) low = middle;
        else high = middle;
    }
    return low;
}

/* A segment in window space, ready for its samples. */
typedef struct Spine {
    float3 p;          /* window position and depth of p' */
    float3 d;          /* q' - p' */
    float inverse_w_p; /* 1/w, linear in window space like depth */
    float inverse_w_d;
    float2 across;     /* unit vector across the segment */
    float2 slope_a, slope_b;
} Spine;

static float2 unpack_slope(const uint packed) {
    return (float2)(as_float(packed << 16), as_float(packed & 0xFFFF0000u));
}

static Spine make_spine(__global const ClippedSegment* segment, const float2 viewport) {
    const float4 p = vload4(0, segment->p);
    const float4 q = vload4(0, segment->q);
    const float3 scale = (float3)(viewport * 0.5f, 0.5f);
    const float3 wp = (p.xyz / p.w + 1.0f) * scale;
    const float3 wq = (q.xyz / q.w + 1.0f) * scale;
    Spine spine;
    spine.p = wp;
    spine.d = wq - wp;
    spine.inverse_w_p = 1.0f / p.w;
    spine.inverse_w_d = 1.0f / q.w - 1.0f / p.w;
    const float length_px = sqrt(spine.d.x * spine.d.x + spine.d.y * spine.d.y);
    spine.across = length_px > 0.0f ? (float2)(-spine.d.y, spine.d.x) / length_px : (float2)(0.0f, 1.0f);
    spine.slope_a = unpack_slope(segment->slope_a);
    spine.slope_b = unpack_slope(segment->slope_b);
    return spine;
}

/* The share of the probes that see sample j of l. The probes fill a box one pixel wide across the line
 * and one sample long along it (§3.2, §4.3). A probe is blocked if the depth buffer holds something
 * nearer than the line there, and nearer than the line's own two faces can be: their planes are known,
 * so the line needs no bias against them. probe_radius: probes per axis. bias_limit: most window depth
 * by which an own face may stand before the line, times w. */
static uint count_visible(const Spine spine, const uint j, const uint l, const uint probes_per_axis,
                          __global const float* depth, const int2 depth_size,
                          const float depth_scale, const float bias_limit, const float bias) {
    uint visible = 0;
    const float per_axis = (float)probes_per_axis;
    for (uint row = 0; row < probes_per_axis; ++row) {
        const float u = ((float)j + ((float)row + 0.5f) / per_axis) / (float)l;
        const float3 point = spine.p + spine.d * u;
        const float limit = bias_limit * (spine.inverse_w_p + spine.inverse_w_d * u);
        for (uint column = 0; column < probes_per_axis; ++column) {
            const float side = ((float)column + 0.5f) / per_axis - 0.5f;
            const float2 probe = (point.xy + spine.across * side) * depth_scale;
            const int2 texel = clamp(convert_int2(floor(probe)), (int2)(0, 0), depth_size - 1);
            const float2 offset = (convert_float2(texel) + 0.5f) / depth_scale - point.xy;
            const float own_a = spine.slope_a.x * offset.x + spine.slope_a.y * offset.y;
            const float own_b = spine.slope_b.x * offset.x + spine.slope_b.y * offset.y;
            const float own = fmin(fmin(own_a, own_b), 0.0f);
            const float nearest = point.z + fmax(own, -limit) - bias;
            visible += depth[texel.y * depth_size.x + texel.x] >= nearest ? 1u : 0u;
        }
    }
    return visible;
}

/* alpha: one byte per sample at its atlas address, 0 to 255. Samples at or beyond `capacity` are left
 * out: the host sees the total, enlarges the atlas and runs the kernel again. */
__kernel void atlas(__global const ClippedSegment* restrict clipped,
                    __global const uint* restrict offsets, const uint count,
                    __global const float* restrict depth, const int2 depth_size,
                    const float2 viewport, const float depth_scale, const uint probes_per_axis,
                    const float bias_limit, const float bias, const uint width, const uint pitch,
                    const uint capacity, const uint block, __global uchar* restrict alpha) {
    const uint total = min(offsets[count], capacity);
    const uint first = (uint)get_global_id(0) * block;
    if (first >= total) return;
    const uint last = min(first + block, total);
    const uint probes = probes_per_axis * probes_per_axis;
    uint i = segment_of_sample(offsets, count, first);
    uint s = first;
    while (s < last) {
        const uint begin = offsets[i];
        const uint end = offsets[i + 1];
        if (end <= s) {
            ++i;
            continue;
        }
        const Spine spine = make_spine(clipped + i, viewport);
        const uint address = atlas_address(begin, width, pitch);
        const uint stop = min(end, last);
        for (; s < stop; ++s) {
            const uint j = s - begin;
            const uint visible = count_visible(spine, j, end - begin, probes_per_axis, depth, depth_size,
                                               depth_scale, bias_limit, bias);
            alpha[address + j] = (uchar)((visible * 255u + probes / 2u) / probes);
        }
        ++i;
    }
}
