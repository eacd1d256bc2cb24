/* temporal: visibility carried over from the frame before, so that lines don't sparkle in motion.
 *
 * Where a line runs along something that hides a part of its width, its visibility depends on where
 * the two fall between the texels of the depth buffer, and changes at random from frame to frame. A
 * moving average over frames removes these changes; each sample is found again by its place on the
 * line.
 *
 * One work-item per block of `block` neighbouring segments. */

#include "kernels.h"
#include "shared/atlas_samples.h"

static uchar average(const uchar now, const float past, const uint history) {
    /* Otherwise an object that came before the line would leave a ghost of the line. */
    if (now == 0 && history == LA_HISTORY_SCENE) return 0;
    const float change = (float)now - past;
    if (fabs(change) > LA_TEMPORAL_LARGEST_CHANGE) return now;
    /* A sample that is all hidden or all visible gets there in the end. */
    const bool extreme = now == 0 || now == 255;
    if (extreme && fabs(change) < LA_TEMPORAL_SMALLEST_CHANGE) return now;
    return (uchar)(past + change * LA_TEMPORAL_SHARE + 0.5f);
}

/* Where a segment stands in tables by segment. */
typedef struct Places {
    uint own;    /* in `ranges`: a silhouette keeps its row, whatever its place in a chain */
    uint before; /* in the frame before */
    bool there;  /* true if the segment was there, and ran the same way */
} Places;

static Places places_of(const uint i, const uint first, __global const uint* origins,
                        __global const uint* positions_before) {
    Places places = {i, i, true};
    if (i < first) return places;
    const uint origin = origins[i - first] - 1u;
    const uint position = positions_before[origin >> 1];
    places.own = first + (origin >> 1);
    places.before = first + ((position - 1u) >> 1);
    places.there = position != 0 && ((position - 1u) & 1u) == (origin & 1u);
    return places;
}

/* alpha: that of this frame, read and written. before: that of the frame before, from
 * offsets_before on. ranges: clip parameters t0 and t1 of every segment in the frame before, 16
 * bits each; the kernel replaces them by those of this frame. origins: those of this frame's
 * chains. positions_before: those of the frame before. chain_write says what both hold. */
KERNEL(temporal, TemporalParameters) {
    const uint b = (uint)get_global_id(0);
    const uint first = b * args.block;
    if (first >= args.count) return;
    const uint last = min(first + args.block, args.count);
    for (uint i = first; i < last; ++i) {
        const uint s = offsets[i];
        const uint l = offsets[i + 1] - s;
        if (!is_in_atlas(args.capacity, s, l)) continue;
        const float t0 = clipped[i].t0;
        const float t1 = clipped[i].t1;
        const bool follows = args.history != LA_HISTORY_NONE;
        const Places places = places_of(i, args.first, origins, positions_before);
        const uint range = ranges[places.own];
        const uint from =
            (uint)(clamp(t0, 0.0f, 1.0f) * 65535.0f + 0.5f); /* centre lines hang over */
        const uint range_now = from | (uint)(clamp(t1, 0.0f, 1.0f) * 65535.0f + 0.5f) << 16;
        ranges[places.own] = range_now;
        if (!follows || !places.there) continue;
        const uint s_before = offsets_before[places.before];
        const uint l_before = offsets_before[places.before + 1] - s_before;
        if (l_before == 0) continue;
        __global uchar* own = alpha + s;
        __global const uchar* own_before = before + s_before;
        if (l == l_before && range == range_now) { /* the usual case: sample by sample */
            for (uint j = 0; j < l; ++j) {
                if (own[j] != own_before[j])
                    own[j] = average(own[j], (float)own_before[j], args.history);
            }
            continue;
        }
        const float t0_before = (float)(range & 0xFFFFu) / 65535.0f;
        const float length_before = (float)(range >> 16) / 65535.0f - t0_before;
        if (length_before <= 0.0f) continue;
        const float wp = clipped[i].p[3];
        const float wq = clipped[i].q[3];
        for (uint j = 0; j < l; ++j) {
            /* From the screen to the line in space, and from there to the screen of the frame
             * before. The change of depth along the line is taken for the same in both frames. */
            const float u = ((float)j + 0.5f) / (float)l;
            const float in_space = u * wp / (u * wp + (1.0f - u) * wq);
            const float t = (t0 + (t1 - t0) * in_space - t0_before) / length_before;
            if (!(t >= 0.0f && t <= 1.0f)) continue;
            const float u_before = t * wq / (t * wq + (1.0f - t) * wp);
            const float x = clamp(u_before * (float)l_before - 0.5f, 0.0f, (float)(l_before - 1));
            const uint low = (uint)x;
            const uint high = min(low + 1, l_before - 1);
            const float a = (float)own_before[low];
            const float past = a + ((float)own_before[high] - a) * (x - (float)low);
            own[j] = average(own[j], past, args.history);
        }
    }
}
