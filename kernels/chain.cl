/* chain: the silhouettes of a frame as paths, in the order in which they follow each other.
 *
 * chain_link finds which silhouette goes on in which other at their common vertices. chain_jump
 * finds how far it is from each silhouette to the ends of its chain, for open chains and loops
 * alike (list ranking by pointer jumping: Wyllie 1979). chain_place finds each silhouette's place
 * in the chain, and chain_write writes the segments. All numbers are whole, except in the choice of
 * the straightest pair, and results do not depend on the order in which work-items run. A chain is
 * named after its least silhouette, begins there if it is a loop, and runs in the direction of that
 * silhouette. So a chain keeps its name from frame to frame as long as that edge is a silhouette.
 * If the frame before is known, its silhouettes come first in the order and keep their direction.
 * Then a chain keeps its name as long as any of its edges is a silhouette. */

#include "kernels.h"
#include "shared/clipping.h"

/* Silhouettes that are paired at a vertex. If more meet there, the others end there. */
#define MOST_MEETING 8

static float dot_of(const float3 a, const float3 b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/* The direction in which a line leaves a vertex, as the eye sees it: without its part along the
 * view. Zero if that is all of it. */
static float3 seen_direction(const float3 from, const float3 to, const float4 eye) {
    const float3 to_eye = xyz(eye) - from * eye.w;
    const float3 way = to - from;
    const float reach = dot_of(to_eye, to_eye);
    const float3 across =
        reach > 0.0f ? way - to_eye * (dot_of(way, to_eye) / reach) : float3(0.0f, 0.0f, 0.0f);
    const float length = sqrt(dot_of(across, across));
    return length > 0.0f ? across / length : float3(0.0f, 0.0f, 0.0f);
}

/* Returns the end in which `own` goes on at a vertex where more than two ends meet, or `own` if
 * there is none. The straightest pair is joined first, then the straightest of the other ends. */
static int straightest_partner(const int own, const float3* directions, const int count) {
    uint left = (1u << count) - 1u;
    for (int joined = 0; joined < count / 2; ++joined) {
        int first = 0, second = 0;
        float straightest = -2.0f;
        for (int i = 0; i < count; ++i) {
            if ((left >> i & 1u) == 0) continue;
            for (int j = i + 1; j < count; ++j) {
                if ((left >> j & 1u) == 0) continue;
                const float straight = -dot_of(directions[i], directions[j]);
                if (!(straight > straightest)) continue;
                straightest = straight;
                first = i;
                second = j;
            }
        }
        if (first == own) return second;
        if (second == own) return first;
        left &= ~(1u << first | 1u << second);
    }
    return own;
}

/* The vertex at end `end` (0: p, 1: q) of a candidate. */
static uint vertex_at(__global const Segment* candidate, const uint end) {
    return end != 0 ? candidate->q : candidate->p;
}

/* The way that goes on behind an end of candidate `c`, an edge of the mesh. */
static uint way_on(const ChainParameters* args, const uint c, const uint end,
                   __global const Segment* segments, __global const float* vertices,
                   __global const uint* end_offsets, __global const uint* ends,
                   __global const uint* numbers) {
    __global const Segment* candidates = segments + args->first;
    const uint vertex = vertex_at(candidates + c, end);
    uint meeting[MOST_MEETING];
    int count = 0, own = -1;
    for (uint k = end_offsets[vertex]; k < end_offsets[vertex + 1]; ++k) {
        const uint other = ends[k] >> 1;
        if (numbers[other + 1] == numbers[other]) continue;
        if (count == MOST_MEETING) break;
        if (ends[k] == (c << 1 | end)) own = count;
        meeting[count++] = ends[k];
    }
    if (count < 2 || own < 0) return LA_WAY_ENDS;
    int partner = 1 - own;
    if (count > 2) {
        float3 directions[MOST_MEETING];
        const float3 from = vload3(vertex, vertices);
        for (int k = 0; k < count; ++k) {
            const uint far = vertex_at(candidates + (meeting[k] >> 1), 1u - (meeting[k] & 1u));
            directions[k] = seen_direction(from, vload3(far, vertices), to_float4(args->eye));
        }
        partner = straightest_partner(own, directions, count);
    }
    /* A silhouette that is entered at its p is taken from p to q. */
    const uint other = numbers[meeting[partner] >> 1];
    if (partner == own || other >= args->count) return LA_WAY_ENDS;
    return other << 1 | (meeting[partner] & 1u);
}

/* The way that goes on behind an end of a contour. Behind its q another contour begins with its p,
 * and the other way round. */
static uint contour_on(const uint count, __global const ContourCrossing* crossing, const uint end) {
    const uint other = end != 0 ? crossing->after : crossing->before;
    return other < count ? other << 1 | (1u - end) : LA_WAY_ENDS;
}

/* How way 2 n + d of candidate c ranks among those that name a chain: the last bit says that the
 * chain runs the other way. */
static uint rank_of(const uint way, const uint c, const uint follows,
                    __global const uint* positions_before) {
    if (follows == 0) return way;
    const uint before = positions_before[c];
    return before == 0 ? way | LA_RANK_NEW : way ^ ((before - 1u) & 1u);
}

/* One work-item per silhouette that there is room for. If there are fewer, LA_NO_SILHOUETTE is
 * chosen for the last ones. Each of these is a chain by itself, behind all others, of a segment
 * that no frame draws. If there are more, the chains have gaps, and the host does the frame again.
 *
 * chosen, numbers: of `silhouette`; crossings: of `contour`.
 * end_offsets, ends: for every vertex of the mesh the ends of edges there, as 2 i + end for
 * candidate i. ways: each gets a stretch of one silhouette. positions_before: `positions` of the
 * frame before, if it counts. */
KERNEL(chain_link, ChainParameters) {
    const uint n = (uint)get_global_id(0);
    if (n >= args.count) return;
    const uint c = chosen[n];
    for (uint d = 0; d < 2; ++d) {
        const uint end = 1u - d;
        ChainWay way;
        way.next = LA_WAY_ENDS;
        way.least = n << 1 | d | LA_RANK_NEW;
        if (c != LA_NO_SILHOUETTE) {
            way.next = c >= args.contours
                           ? contour_on(args.count, crossings + n, end)
                           : way_on(&args, c, end, segments, vertices, end_offsets, ends, numbers);
            way.least = rank_of(n << 1 | d, c, args.follows, positions_before);
        }
        way.hops = 1;
        way.at = 0;
        ways[n << 1 | d] = way;
    }
}

/* One work-item per way. It takes over what the ways behind its stretch know, one after the other.
 * going[step]: 1 if any way still has to go on. If none has, the next step copies all ways and
 * later steps do nothing, so both tables hold the result.
 *
 * A stretch with the same least way as the stretch behind it has gone round a loop. */
KERNEL(chain_jump, ChainParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || (args.step > 1 && going[args.step - 2] == 0)) return;
    ChainWay way = ways[i];
    for (uint k = 1; k < LA_WAY_GROWTH && way.next < LA_WAY_CLOSES; ++k) {
        const ChainWay behind = ways[way.next];
        if (behind.next == LA_WAY_CLOSES) {
            way.at = way.least == behind.least ? way.at : (way.hops + behind.at) % behind.hops;
            way.hops = behind.hops;
            way.next = LA_WAY_CLOSES;
        } else if (behind.least == way.least) {
            way.hops += behind.at - way.at;
            way.next = LA_WAY_CLOSES;
        } else {
            if (behind.least < way.least) way.at = way.hops + behind.at;
            way.hops += behind.hops;
            way.next = behind.next;
        }
        way.least = min(way.least, behind.least);
    }
    if (way.next < LA_WAY_CLOSES) atomic_max(going + args.step, 1u);
    longer[i] = way;
}

/* One work-item per silhouette. lengths: the length of every chain, at its leader; 0 elsewhere. */
KERNEL(chain_place, ChainParameters) {
    const uint n = (uint)get_global_id(0);
    if (n >= args.count) return;
    const ChainWay on = ways[n << 1], back = ways[n << 1 | 1u];
    uint least = on.least, length, before;
    bool reversed;
    if (on.next == LA_WAY_CLOSES) {
        length = on.hops;
        reversed = (least & 1u) != 0;
        before = reversed ? on.at : (length - on.at) % length;
    } else {
        length = on.hops + back.hops - 1u;
        if (back.least >> 1 < on.least >> 1) least = back.least ^ 1u;
        reversed = (least & 1u) != 0;
        before = (reversed ? on.hops : back.hops) - 1u;
    }
    const uint leader = (least & ~LA_RANK_NEW) >> 1;
    places[n].leader = leader;
    places[n].before = before;
    places[n].after = length - 1u - before;
    places[n].flags =
        (reversed ? LA_PLACE_REVERSED : 0u) | (on.next == LA_WAY_CLOSES ? LA_PLACE_CLOSED : 0u);
    lengths[n] = leader == n ? length : 0;
}

/* True if a contour is a short loop, about a bump or two of a rough surface. */
static bool is_noise(const ChainPlace* place, const uint tag) {
    return (tag & LA_TAG_UNDESIGNED) != 0 && (place->flags & LA_PLACE_CLOSED) != 0 &&
           place->before + place->after < LA_LEAST_LOOP;
}

/* One work-item per silhouette. starts: the scanned lengths. ordered: the segments of the frame;
 * chains stand from `first` on. origins: for each segment of a chain 2 i + 1 if it is candidate i,
 * 2 i + 2 if it is candidate i reversed, 0 if it is none. positions: for each candidate its place
 * among these segments, coded in the same way, or 0. */
KERNEL(chain_write, ChainParameters) {
    const uint n = (uint)get_global_id(0);
    if (n >= args.count) return;
    const ChainPlace place = places[n];
    const uint c = chosen[n];
    const uint position = starts[place.leader] + place.before;
    if (c == LA_NO_SILHOUETTE) {
        /* Without length, and with one face on both sides. */
        const Segment none = {0, 0, 0, 0, 0, 0, 0, LA_KIND_SILHOUETTE};
        ordered[args.first + position] = none;
        origins[position] = 0;
        return;
    }
    const uint turned = (place.flags & LA_PLACE_REVERSED) != 0 ? 1u : 0u;
    Segment segment = segments[args.first + c];
    if (c >= args.contours) {
        const ContourCrossing crossing = crossings[n];
        segment.p = crossing.p + args.lifted;
        segment.q = crossing.q + args.lifted;
        segment.face_b = LA_NO_FACE;
        segment.tag |= LA_TAG_CONTOUR;
        const bool shows_none = args.outside != 0 && (segment.tag & LA_TAG_SOLID) != 0;
        if (crossing.underside != 0) segment.tag |= shows_none ? LA_TAG_BURIED : LA_TAG_UNDERSIDE;
        if (is_noise(&place, segment.tag)) segment.tag |= LA_TAG_BURIED;
    }
    if (turned != 0) {
        const uint p = segment.p;
        segment.p = segment.q;
        segment.q = p;
    }
    segment.from_start = place.before;
    segment.to_end = place.after;
    segment.path = segments[args.first + chosen[place.leader]].path;
    if ((place.flags & LA_PLACE_CLOSED) != 0) segment.tag |= LA_TAG_CLOSED;
    ordered[args.first + position] = segment;
    origins[position] = (c << 1 | turned) + 1u;
    positions[c] = (position << 1 | turned) + 1u;
}
