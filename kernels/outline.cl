/* outline: which parts of lines have the background on one side, and a body on the other side that
 * is some pixels deep, so that a rope is no outline of itself. A place of a line has the background
 * beside it if an infinitely far point beside it is not hidden.
 *
 * By the exact method (exact.h) every segment that is at least partly visible is moved to either
 * side. Parts that are beside the background there are moved to the other side. `visible` finds the
 * visible parts of the moved segments, so ends of outlines are continuous. By the segment atlas the
 * depth buffer is read beside the middle of every sample.
 *
 * Outlines are parts of segments, in the units of runs: samples of the segment, or 0 to 1. Several
 * parts of one segment may overlap, and are in no order.
 *
 * Towards a corner of less than a right angle a body is no longer deep enough. The rest of the
 * segment there is outline like the part before it, if it is no longer than that part and no longer
 * than LA_OUTLINE_CORNER times the wanted depth. So the outline of a wedge of 20 degrees is whole.
 */

#include "kernels.h"
#include "shared/atlas_samples.h"
#include "shared/exact.h"

/* Behind everything that is seen, with a nearness of 0: w, or z of a parallel view. */
#define FAR_W 1e18f
#define FAR_Z 1.0f

static bool can_be_outline(const uint tag) {
    const uint kind = tag & LA_TAG_KIND_MASK;
    return (1u << kind & LA_KINDS_BESIDE) == 0;
}

/* Writes the way beside a segment, `distance` pixels to its left and infinitely far away. p[3] is 0
 * if there is none. */
static void push(const OutlineParameters* args, const float4 p, const float4 q,
                 const float distance, __global ClippedSegment* out) {
    out->p[3] = 0.0f;
    const float2 at_p = xy(p) / p.w, at_q = xy(q) / q.w;
    const float2 half_size = to_float2(args->viewport) * 0.5f;
    const float2 way = (at_q - at_p) * half_size;
    const float length_px = sqrt(way.x * way.x + way.y * way.y);
    if (!(length_px > 0.0f)) return;
    const float2 off = float2(-way.y, way.x) * (distance / length_px) / half_size;
    const bool parallel = args->parallel != 0;
    const float w = parallel ? 1.0f : FAR_W, z = parallel ? FAR_Z : w;
    const float2 from = (at_p + off) * w, to = (at_q + off) * w;
    vstore4(float4(from.x, from.y, z, w), 0, out->p);
    vstore4(float4(to.x, to.y, z, w), 0, out->q);
    out->t0 = 0.0f;
    out->t1 = 1.0f;
    out->own_a = out->own_b = LA_NO_FACE;
}

/* numbers: 1 for a segment that is seen and may be outline, else 0. The scan turns them into
 * numbers of these segments. */
KERNEL(outline_seen, CountParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const bool seen = arcs[i + 1] != arcs[i] && span_offsets[i + 1] != span_offsets[i];
    numbers[i] = seen && can_be_outline(segments[i].tag) ? 1u : 0u;
}

/* seen: the segments that the numbers stand for. pushed: the two ways beside the n-th segment seen,
 * to its right and to its left. */
KERNEL(outline_push, OutlineParameters) {
    const uint n = (uint)get_global_id(0);
    if (n >= args.count) return;
    const uint i = seen[n];
    __global ClippedSegment* out = pushed + LA_OUTLINE_BESIDE * n;
    const ClipEnds ends = lifted_ends(segments + i, clipped + i, args.lift,
                                      to_matrix(args.clip_from_world), vertices);
    push(&args, ends.p, ends.q, -args.reach, out);
    push(&args, ends.p, ends.q, args.reach, out + 1);
}

/* pushed: if the background is beside the n-th segment seen, LA_OUTLINE_STEPS ways on the other
 * side, first for the background to its right. beside_offsets: the offsets of the visible parts of
 * the two ways of outline_push. */
KERNEL(outline_push_in, OutlineParameters) {
    const uint n = (uint)get_global_id(0);
    if (n >= args.count) return;
    const uint i = seen[n];
    const float4 p = vload4(0, clipped[i].p), q = vload4(0, clipped[i].q);
    for (uint side = 0; side < 2; ++side) {
        const uint way = LA_OUTLINE_BESIDE * n + side;
        const bool any = beside_offsets[way + 1] != beside_offsets[way];
        for (uint k = 0; k < LA_OUTLINE_STEPS; ++k) {
            __global ClippedSegment* out =
                pushed + (LA_OUTLINE_WITHIN * n + LA_OUTLINE_STEPS * side + k);
            out->p[3] = 0.0f;
            const float inside = args.depth * (float)(k + 1) / (float)LA_OUTLINE_STEPS;
            if (any) push(&args, p, q, side == 0 ? inside : -inside, out);
        }
    }
}

/* Finds the parts of the n-th segment seen that have the background on one side and a deep enough
 * body on the other. Writes them if there is a table. Returns how many there are. corner: the
 * longest end without a deep enough body that is still outline, as a share of the segment. */
static uint find_deep_parts(const uint n, const float corner, __global const uint* beside_offsets,
                            __global const float* beside, __global const uint* within_offsets,
                            __global const float* within, __global float* out) {
    uint count = 0;
    for (uint side = 0; side < 2; ++side) {
        const uint way = LA_OUTLINE_BESIDE * n + side;
        const uint inner = LA_OUTLINE_WITHIN * n + LA_OUTLINE_STEPS * side;
        const uint first = within_offsets[inner], last = within_offsets[inner + LA_OUTLINE_STEPS];
        for (uint k = beside_offsets[way]; k < beside_offsets[way + 1]; ++k) {
            const float2 part = vload2(k, beside);
            float at = part.x;
            while (at < part.y) {
                float end = part.y;
                for (uint j = first; j < last; ++j) { /* parts of both steps, in no order */
                    const float2 thin = vload2(j, within);
                    if (thin.y <= at) continue;
                    end = fmin(end, fmax(thin.x, at));
                }
                if (end > at) {
                    const float most = fmin(corner, end - at);
                    const float from = at <= most && part.x <= 1e-4f ? 0.0f : at;
                    const float to = 1.0f - end <= most && part.y >= 1.0f - 1e-4f ? 1.0f : end;
                    if (out != 0) vstore2(float2(from, to), count, out);
                    ++count;
                }
                at = end;
                for (uint j = first; j < last; ++j) {
                    const float2 thin = vload2(j, within);
                    if (thin.x <= end) at = fmax(at, thin.y);
                }
                if (!(at > end)) break;
            }
        }
    }
    return count;
}

static float corner_of(const float depth, __global const uint* arcs, const uint i) {
    const float units = (float)max(arcs[i + 1] - arcs[i], 1u);
    return LA_OUTLINE_CORNER * LA_ARC_UNITS_PER_PIXEL * depth / units;
}

KERNEL(outline_parts_count, OutlineParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const bool seen = numbers[i + 1] != numbers[i];
    counts[i] = seen ? find_deep_parts(numbers[i], corner_of(args.depth, arcs, i), beside_offsets,
                                       beside, within_offsets, within, 0)
                     : 0;
}

KERNEL(outline_parts_write, OutlineParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || part_offsets[args.count] > args.capacity) return;
    if (part_offsets[i + 1] == part_offsets[i]) return;
    find_deep_parts(numbers[i], corner_of(args.depth, arcs, i), beside_offsets, beside,
                    within_offsets, within, parts + 2 * (size_t)part_offsets[i]);
}

/* The depth texels or numbers that the frame shows. */
typedef struct Shown {
    int2 size; /* texels */
    float scale;
    __global const float* depth;
    __global const uint* numbers; /* 0: it has none */
} Shown;

static Shown make_shown(const OutlineSamplesParameters* args, __global const float* depth,
                        __global const uint* numbers) {
    Shown shown;
    shown.size = to_int2(args->depth_size);
    shown.scale = args->depth_scale;
    shown.depth = depth;
    shown.numbers = args->numbered != 0 ? numbers : 0;
    return shown;
}

/* True if nothing is drawn at a place of the window. */
static bool is_background(const Shown* shown, const float2 place) {
    const int2 texel = clamp(convert_int2_rtn(place * shown->scale), int2(0, 0), shown->size - 1);
    const int index = texel.y * shown->size.x + texel.x;
    if (shown->numbers != 0) return shown->numbers[index] == LA_NO_FACE;
    return shown->depth[index] >= 1.0f;
}

/* True if there is a deep enough body beside a place. left: a unit vector. */
static bool is_deep(const OutlineSamplesParameters* args, const Shown* shown, const float2 place,
                    const float2 left) {
    for (uint k = 0; k < LA_OUTLINE_STEPS; ++k) {
        const float inside = args->depth * (float)(k + 1) / (float)LA_OUTLINE_STEPS;
        if (is_background(shown, place + left * inside)) return false;
    }
    return true;
}

static bool is_beside(const OutlineSamplesParameters* args, const Shown* shown, const float2 place,
                      const float2 left) {
    const float2 off = left * args->reach;
    return is_background(shown, place + off) || is_background(shown, place - off);
}

static bool sample_is_outline(const OutlineSamplesParameters* args, const Shown* shown,
                              const float2 place, const float2 left) {
    const float2 off = left * args->reach;
    return (is_background(shown, place + off) && is_deep(args, shown, place, left * -1.0f)) ||
           (is_background(shown, place - off) && is_deep(args, shown, place, left));
}

/* Finds the parts of segment i that are outline. Writes them if there is a table. Returns how many
 * there are. */
static uint find_parts(const OutlineSamplesParameters* args, __global const Segment* segments,
                       __global const ClippedSegment* clipped, __global const uint* offsets,
                       const Shown* shown, const uint i, __global float* out) {
    const uint l = offsets[i + 1] - offsets[i];
    if (l == 0 || !can_be_outline(segments[i].tag)) return 0;
    const float4 clip_p = vload4(0, clipped[i].p), clip_q = vload4(0, clipped[i].q);
    const float2 half_size = to_float2(args->viewport) * 0.5f;
    const float2 p = (xy(clip_p) / clip_p.w + 1.0f) * half_size;
    const float2 way = (xy(clip_q) / clip_q.w + 1.0f) * half_size - p;
    const float length_px = sqrt(way.x * way.x + way.y * way.y);
    if (!(length_px > 0.0f)) return 0;
    const float2 left = float2(-way.y, way.x) * (1.0f / length_px);
    const uint corner = (uint)(LA_OUTLINE_CORNER * args->depth * (float)l / length_px);
    uint count = 0, first = l; /* of the part that is open */
    bool beside_so_far = true; /* the background has been beside the line from the segment's start
                                  on */
    for (uint k = 0; k <= l; ++k) {
        const float2 place = p + way * (((float)k + 0.5f) / (float)l);
        const bool free = k < l && sample_is_outline(args, shown, place, left);
        if (free && first == l) {
            first = k;
        } else if (!free && first < l) {
            const uint most = min(corner, k - first);
            const uint from = first <= most && beside_so_far ? 0 : first;
            uint to = k;
            if (l - k <= most)
                while (to < l &&
                       is_beside(args, shown, p + way * (((float)to + 0.5f) / (float)l), left))
                    ++to;
            if (out != 0) vstore2(float2((float)from, (float)(to == l ? l : k)), count, out);
            ++count;
            first = l;
        }
        if (beside_so_far && first == l && k < l)
            beside_so_far = k < corner && is_beside(args, shown, place, left);
    }
    return count;
}

KERNEL(outline_samples_count, OutlineSamplesParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const Shown shown = make_shown(&args, depth, numbers);
    counts[i] = offsets[args.count] > args.sample_capacity
                    ? 0
                    : find_parts(&args, segments, clipped, offsets, &shown, i, 0);
}

KERNEL(outline_samples_write, OutlineSamplesParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || part_offsets[args.count] > args.part_capacity) return;
    if (part_offsets[i + 1] == part_offsets[i]) return;
    const Shown shown = make_shown(&args, depth, numbers);
    find_parts(&args, segments, clipped, offsets, &shown, i, parts + 2 * (size_t)part_offsets[i]);
}
