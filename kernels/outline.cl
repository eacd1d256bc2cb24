/* outline: which parts of lines have the background on one side. A place of a line has it where a
 * place beside it, infinitely far away, is hidden by nothing.
 *
 * Of the exact method (exact.h): every segment that is seen is pushed out to either side, and
 * `visible` finds what of that is seen: those parts are cut, with continuous ends. Of the segment
 * atlas: the depth buffer is looked at beside the middle of every sample.
 *
 * Either way they are parts of segments, in the units of runs: samples of the segment, or 0 to 1.
 * Several of one segment may overlap, and are in no order. */

#include "atlas_address.h"
#include "exact.h"
#include "kernels.h"

/* Behind everything that is seen, with a nearness of 0: w, or z of a parallel view. */
#define FAR_W 1e18f
#define FAR_Z 1.0f

static bool can_be_outline(const uint tag) {
    const uint kind = tag & LA_TAG_KIND_MASK;
    return kind != LA_KIND_FILE && kind != LA_KIND_HATCHING;
}

/* pushed: of segment i the two ways beside it, to its right and to its left; their p[3] is 0 if
 * nothing is looked for there. */
KERNEL(outline_push, OutlineParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    pushed[2 * i].p[3] = pushed[2 * i + 1].p[3] = 0.0f;
    if (arcs[i + 1] == arcs[i] || span_offsets[i + 1] == span_offsets[i]) return;
    if (!can_be_outline(segments[i].tag)) return;
    const float4 p = vload4(0, clipped[i].p), q = vload4(0, clipped[i].q);
    const float2 at_p = xy(p) / p.w, at_q = xy(q) / q.w;
    const float2 half_size = to_float2(args.viewport) * 0.5f;
    const float2 way = (at_q - at_p) * half_size;
    const float length_px = sqrt(way.x * way.x + way.y * way.y);
    if (!(length_px > 0.0f)) return;
    const float2 left = float2(-way.y, way.x) * (args.reach / length_px) / half_size;
    const bool parallel = args.parallel != 0;
    const float w = parallel ? 1.0f : FAR_W;
    for (uint side = 0; side < 2; ++side) {
        const float2 off = left * (side == 0 ? -1.0f : 1.0f);
        const float2 from = (at_p + off) * w, to = (at_q + off) * w;
        __global ClippedSegment* out = pushed + (2 * i + side);
        vstore4(float4(from.x, from.y, parallel ? FAR_Z : w, w), 0, out->p);
        vstore4(float4(to.x, to.y, parallel ? FAR_Z : w, w), 0, out->q);
        out->t0 = 0.0f;
        out->t1 = 1.0f;
        out->own_a = out->own_b = LA_NO_FACE;
    }
}

/* Whether the depth buffer has nothing at a place of the window. */
static bool is_background(const OutlineSamplesParameters* args, __global const float* depth,
                          const float2 place) {
    const int2 size = to_int2(args->depth_size);
    const int2 texel = clamp(convert_int2_rtn(place * args->depth_scale), int2(0, 0), size - 1);
    return depth[texel.y * size.x + texel.x] >= 1.0f;
}

static bool sample_has_background(const OutlineSamplesParameters* args, __global const float* depth,
                                  const float2 place, const float2 left) {
    return is_background(args, depth, place + left) || is_background(args, depth, place - left);
}

/* Parts of segment i, written if there is a table; how many. */
static uint find_parts(const OutlineSamplesParameters* args, __global const Segment* segments,
                       __global const ClippedSegment* clipped, __global const uint* offsets,
                       __global const float* depth, const uint i, __global float* out) {
    const uint l = offsets[i + 1] - offsets[i];
    if (l == 0 || !can_be_outline(segments[i].tag)) return 0;
    const float4 clip_p = vload4(0, clipped[i].p), clip_q = vload4(0, clipped[i].q);
    const float2 half_size = to_float2(args->viewport) * 0.5f;
    const float2 p = (xy(clip_p) / clip_p.w + 1.0f) * half_size;
    const float2 way = (xy(clip_q) / clip_q.w + 1.0f) * half_size - p;
    const float length_px = sqrt(way.x * way.x + way.y * way.y);
    if (!(length_px > 0.0f)) return 0;
    const float2 left = float2(-way.y, way.x) * (args->reach / length_px);
    uint count = 0;
    bool open = false;
    for (uint k = 0; k < l; ++k) {
        const float2 place = p + way * (((float)k + 0.5f) / (float)l);
        const bool free = sample_has_background(args, depth, place, left);
        if (free && !open && out != 0) out[2 * count] = (float)k;
        if (!free && open && out != 0) out[2 * count + 1] = (float)k;
        if (!free && open) ++count;
        open = free;
    }
    if (open && out != 0) out[2 * count + 1] = (float)l;
    return open ? count + 1 : count;
}

KERNEL(outline_samples_count, OutlineSamplesParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    counts[i] = offsets[args.count] > args.sample_capacity
                    ? 0
                    : find_parts(&args, segments, clipped, offsets, depth, i, 0);
}

KERNEL(outline_samples_write, OutlineSamplesParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || part_offsets[args.count] > args.part_capacity) return;
    if (part_offsets[i + 1] == part_offsets[i]) return;
    find_parts(&args, segments, clipped, offsets, depth, i, parts + 2 * (size_t)part_offsets[i]);
}
