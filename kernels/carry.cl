/* carry: texture coordinates of silhouettes carried over from frame to frame.
 *
 * If each frame measured coordinates along its chain anew, a silhouette's coordinate would shift
 * whenever another edge of the chain comes or goes, and textures would crawl. So every candidate
 * remembers its coordinates, as do the samples of "Coherent stylized silhouettes" (Kalnins et al.
 * 2003) and the vertices of "Active strokes" (Benard et al. 2012), and the next frame's chain takes
 * them over. New silhouettes get coordinates between remembered ones. Coordinates that were
 * remembered from different places of other chains stay in pieces; a short piece takes the
 * coordinates of a longer one beside it. Textures must not stay stretched. So coordinates shift
 * towards those of the chain's length: towards the mean of their neighbours, and slowly towards
 * that of their piece, by no more than `limit`.
 *
 * Lengths are those of the chain with its zigzags smoothed away, because zigzags along edges of the
 * mesh come and go. All lengths are whole numbers of 1/256 pixels, the same on every device. An
 * offset is a coordinate less its length: if a texture is not stretched, offsets are the same all
 * along a piece. */

#include "kernels.h"
#include "shared/run.h"

/* A joint is smoothed with so many segments on either side, no farther away than this. */
#define SMOOTHED_SEGMENTS 16u
#define SMOOTHED_REACH (12u * 256u)
/* Offsets that differ by more than this, or by more than half of the way between them, belong to
 * different pieces. */
#define LARGEST_STEP (16 * 256)
/* A piece shorter than this gives way to a longer one beside it. */
#define SHORT_PIECE (32u * 256u)
#define MOST_STEPS 64
/* A silhouette's offset is drawn to the mean offset of so many neighbours on either side. The
 * shares say how much of the way it goes per frame: to that mean, to the mean of the piece, and
 * back to the limit. */
#define NEIGHBOURS 12u
#define SHARE_NEAR(offset) ((offset) / 4)
#define SHARE_PIECE(offset) ((offset) / 50)
#define SHARE_BEYOND(offset) ((offset) / 16)
/* Means are of 1/16 pixels, so that their sums fit. */
#define UNITS_OF_MEANS 16

static bool is_drawn(__global const uint* arcs, const uint s) {
    return arcs[s + 1] != arcs[s];
}

/* How far a path goes on from the start of segment `from`, no farther than it is smoothed. */
static uint reach_of(const Frame frame, const uint from, const bool forward) {
    uint sum = 0;
    for (uint r = 0; r < SMOOTHED_SEGMENTS && sum < SMOOTHED_REACH; ++r) {
        const uint s = forward ? from + r : from - 1u - r;
        if (r > 0 && !(goes_on(frame, forward ? s - 1u : s) && is_drawn(frame.arcs, s))) break;
        sum += frame.arcs[s + 1] - frame.arcs[s];
        if (!forward && frame.segments[s].from_start == 0) break;
    }
    return min(sum, SMOOTHED_REACH);
}

/* Sum of the places along a path from the start of segment `from`, over the length `reach`. */
static float2 sum_along(const Frame frame, const uint from, const bool forward, const uint reach) {
    float2 sum = float2(0.0f, 0.0f);
    uint left = reach;
    for (uint r = 0; left > 0; ++r) {
        const uint s = forward ? from + r : from - 1u - r;
        const float2 p = window_position(frame.clipped[s].p, frame.viewport);
        const float2 q = window_position(frame.clipped[s].q, frame.viewport);
        const float2 near = forward ? p : q, far = forward ? q : p;
        const uint length = frame.arcs[s + 1] - frame.arcs[s];
        const uint taken = min(length, left);
        const float2 to = near + (far - near) * ((float)taken / (float)length);
        sum = sum + (near + to) * (0.5f * (float)taken);
        left -= taken;
    }
    return sum;
}

/* The end of a segment on the screen with zigzags smoothed: the mean of the path around the end,
 * equally far to either side. */
static float2 smoothed_end(const Frame frame, const uint s, const bool at_end) {
    const float2 own =
        window_position(at_end ? frame.clipped[s].q : frame.clipped[s].p, frame.viewport);
    if ((at_end ? frame.segments[s].to_end : frame.segments[s].from_start) == 0) return own;
    const uint joint = at_end ? s + 1u : s; /* the segment that begins there */
    if (!is_drawn(frame.arcs, joint - 1u) || !goes_on(frame, joint - 1u)) return own;
    const uint reach = min(reach_of(frame, joint, false), reach_of(frame, joint, true));
    const float2 sum = sum_along(frame, joint, false, reach) + sum_along(frame, joint, true, reach);
    return sum / (float)(2u * reach);
}

static uint packed_range(__global const ClippedSegment* segment) {
    return (uint)(segment->t0 * 65535.0f + 0.5f) | (uint)(segment->t1 * 65535.0f + 0.5f) << 16;
}

/* Where a clip parameter lay in the frame before, as a share of the part that was drawn. The change
 * of depth along the line is taken for the same in both frames. */
static float share_before(const float t, const float t0, const float length, const float wp,
                          const float wq) {
    const float in_space = (t - t0) / length;
    if (!(in_space > 0.0f && in_space < 1.0f)) return in_space;
    return in_space * wq / (in_space * wq + (1.0f - in_space) * wp);
}

/* One work-item per silhouette. lengths: its smoothed length. found: 1 if the frame before had it
 * and it ran the same way. recalled: its coordinates then, at the ends that it has in this frame.
 */
KERNEL(carry_recall, CarryParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    lengths[i] = 0;
    found[i] = 0;
    const uint s = args.first + i;
    if (!is_drawn(arcs, s)) return;
    const Frame frame = {segments, clipped, 0, arcs, to_float2(args.viewport), 0.0f};
    const float2 way = smoothed_end(frame, s, true) - smoothed_end(frame, s, false);
    lengths[i] = (uint)(sqrt(way.x * way.x + way.y * way.y) * LA_ARC_UNITS_PER_PIXEL + 0.5f);
    const uint origin = origins[i] - 1u;
    __global const int* own = memory + LA_MEMORY_WORDS * (origin >> 1);
    if ((uint)own[LA_MEMORY_STAMP] != ((args.frame - 1u) << 1 | (origin & 1u))) return;
    const int start = own[LA_MEMORY_START], end = own[LA_MEMORY_END];
    const uint range = (uint)own[LA_MEMORY_RANGE];
    found[i] = 1;
    recalled[2 * i] = start;
    recalled[2 * i + 1] = end;
    if (range == packed_range(clipped + s)) return;
    const float t0 = (float)(range & 0xFFFFu) / 65535.0f;
    const float length = (float)(range >> 16) / 65535.0f - t0;
    if (!(length > 0.0f)) {
        found[i] = 0;
        return;
    }
    const float wp = clipped[s].p[3], wq = clipped[s].q[3], all = (float)(end - start);
    recalled[2 * i] = start + (int)(all * share_before(clipped[s].t0, t0, length, wp, wq));
    recalled[2 * i + 1] = start + (int)(all * share_before(clipped[s].t1, t0, length, wp, wq));
}

/* Offset at an end (0: start, 1: end) of silhouette i, whose chain begins with `chain`. */
static int offset_at(__global const uint* lengths, __global const int* recalled, const uint chain,
                     const uint i, const uint end) {
    return recalled[2 * i + end] - (int)(lengths[i + end] - lengths[chain]);
}

/* True if the second of two silhouettes of a chain, with only new ones between them, begins another
 * piece. */
static bool breaks_between(__global const uint* lengths, __global const int* recalled,
                           const uint chain, const uint before, const uint after) {
    const int gap = (int)(lengths[after] - lengths[before + 1]);
    const int step = offset_at(lengths, recalled, chain, after, 0) -
                     offset_at(lengths, recalled, chain, before, 1);
    return (int)abs(step) > max(LARGEST_STEP, gap / 2);
}

/* The last silhouette of a piece from i on in one direction, or the first one that is too far away
 * to matter. */
typedef struct PieceEnd {
    uint at;
    bool broken; /* another piece follows */
    uint beyond; /* where that piece begins */
} PieceEnd;

static PieceEnd piece_end(const CarryParameters args, __global const Segment* segments,
                          __global const uint* lengths, __global const uint* found,
                          __global const int* recalled, const uint i, const bool forward) {
    const uint chain = i - segments[args.first + i].from_start;
    const uint last = i + segments[args.first + i].to_end;
    PieceEnd end = {i, false, i};
    uint at = i;
    for (int step = 0; step < MOST_STEPS && at != (forward ? last : chain); ++step) {
        at = forward ? at + 1u : at - 1u;
        if (found[at] == 0) continue;
        const uint a = forward ? end.at : at, b = forward ? at : end.at;
        if (breaks_between(lengths, recalled, chain, a, b)) {
            end.broken = true;
            end.beyond = at;
            break;
        }
        end.at = at;
        if ((forward ? lengths[at + 1] - lengths[i] : lengths[i + 1] - lengths[at]) >= SHORT_PIECE)
            break;
    }
    return end;
}

/* One work-item per silhouette. kept: 1 if its recalled coordinates count. */
KERNEL(carry_keep, CarryParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    kept[i] = found[i];
    if (found[i] == 0 || args.limit == 0) return;
    const PieceEnd start = piece_end(args, segments, lengths, found, recalled, i, false);
    const PieceEnd end = piece_end(args, segments, lengths, found, recalled, i, true);
    const uint own = lengths[end.at + 1] - lengths[start.at];
    if (own >= SHORT_PIECE) return;
    if (start.broken) {
        const PieceEnd far =
            piece_end(args, segments, lengths, found, recalled, start.beyond, false);
        if (lengths[start.beyond + 1] - lengths[far.at] >= own) kept[i] = 0;
    }
    if (end.broken) {
        const PieceEnd far = piece_end(args, segments, lengths, found, recalled, end.beyond, true);
        if (lengths[far.at + 1] - lengths[end.beyond] > own) kept[i] = 0;
    }
}

/* One work-item per silhouette; the first ones take the kept silhouettes, the others write zeros.
 * kept: scanned. list: the kept silhouettes. breaks: 1 where a piece begins behind another. means:
 * the offset in the middle of each. */
KERNEL(carry_breaks, CarryParameters) {
    const uint k = (uint)get_global_id(0);
    if (k >= args.count) return;
    breaks[k] = 0;
    means[k] = 0;
    if (k >= kept[args.count]) return;
    const uint i = list[k];
    const uint chain = i - segments[args.first + i].from_start;
    const int start = offset_at(lengths, recalled, chain, i, 0);
    const int end = offset_at(lengths, recalled, chain, i, 1);
    means[k] = (uint)((start + end) / (2 * UNITS_OF_MEANS));
    if (k == 0) return;
    const uint before = list[k - 1];
    const bool other = before < chain || breaks_between(lengths, recalled, chain, before, i);
    breaks[k] = other ? 1u : 0u;
}

/* One work-item as in carry_breaks. breaks: scanned. pieces: where each piece begins in the list,
 * and where the last one ends. */
KERNEL(carry_pieces, CarryParameters) {
    const uint k = (uint)get_global_id(0);
    const uint total = kept[args.count];
    if (k >= total) return;
    if (k == 0 || breaks[k + 1] != breaks[k]) pieces[breaks[k + 1]] = k;
    if (k + 1 == total) pieces[breaks[k + 1] + 1] = total;
}

/* The way from `own` to the mean of the entries from `first` up to but without `last`, in a scanned
 * table. */
static int to_mean(__global const uint* means, const uint own, const uint first, const uint last) {
    const uint count = last - first;
    return (int)(means[last] - means[first] - own * count) / (int)count;
}

/* One work-item as in carry_breaks. means: scanned. shifts: how far each offset goes towards the
 * means. */
KERNEL(carry_settle, CarryParameters) {
    const uint k = (uint)get_global_id(0);
    if (k >= kept[args.count]) return;
    shifts[k] = 0;
    if (args.limit == 0) return;
    const uint piece = breaks[k + 1];
    const uint first = pieces[piece], last = pieces[piece + 1];
    const uint own = means[k + 1] - means[k];
    const uint reach = min(NEIGHBOURS, min(k - first, last - 1u - k));
    const int near = to_mean(means, own, k - reach, k + reach + 1u);
    const int wanted =
        (SHARE_NEAR(near) + SHARE_PIECE(to_mean(means, own, first, last))) * UNITS_OF_MEANS;
    const int within = clamp(wanted, -(int)args.limit, (int)args.limit);
    shifts[k] = within + SHARE_BEYOND(wanted - within);
}

/* The tables of the list that carry_place reads. */
typedef struct KeptTables {
    __global const uint* lengths;
    __global const int* recalled;
    __global const uint* kept;
    __global const uint* list;
    __global const uint* breaks;
    __global const int* shifts;
    uint chain, last; /* of its silhouettes */
} KeptTables;

/* The offset that entry k of the list gets at an end. Entries that touch get one offset there,
 * except in a picture that stands still, where nothing changes. */
static int settled_offset(const KeptTables t, const uint k, const uint end, const uint limit) {
    const uint i = t.list[k];
    const int own = offset_at(t.lengths, t.recalled, t.chain, i, end) + t.shifts[k];
    if (limit == 0 || (end == 0 ? i == t.chain : i == t.last)) return own;
    const uint beside = end == 0 ? i - 1u : i + 1u;
    if (t.kept[beside + 1] == t.kept[beside]) return own;
    const uint other = end == 0 ? k - 1u : k + 1u;
    const uint later = max(k, other);
    if (t.breaks[later + 1] != t.breaks[later]) return own;
    return (own + offset_at(t.lengths, t.recalled, t.chain, beside, 1u - end) + t.shifts[other]) /
           2;
}

/* Offset at an end of a silhouette that is not kept, between entries k - 1 and k of the list. */
static int filled_offset(const KeptTables t, const uint k, const uint i, const uint end,
                         const uint limit) {
    const uint total_before = t.kept[t.chain], total = t.kept[t.last + 1];
    if (total == total_before) /* all silhouettes are new: zero is in the middle */
        return -(int)((t.lengths[t.last + 1] - t.lengths[t.chain]) / 2u);
    if (k == total_before) return settled_offset(t, k, 0, limit);
    const int before = settled_offset(t, k - 1u, 1, limit);
    if (k == total) return before;
    const int after = settled_offset(t, k, 0, limit);
    const uint from = t.lengths[t.list[k - 1u] + 1u];
    const uint gap = t.lengths[t.list[k]] - from;
    const uint at = t.lengths[i + end] - from;
    if (t.breaks[k + 1] != t.breaks[k])
        return (t.lengths[i] + t.lengths[i + 1] - 2u * from) < gap ? before : after;
    if (gap == 0) return end == 0 ? before : after;
    return before + (int)((float)(after - before) * ((float)at / (float)gap));
}

/* One work-item per silhouette. carried: its coordinates at both ends. memory: what this frame
 * remembers. */
KERNEL(carry_place, CarryParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || origins[i] == 0) return;
    const uint s = args.first + i;
    const uint chain = i - segments[s].from_start;
    const KeptTables tables = {lengths, recalled, kept,  list,
                               breaks,  shifts,   chain, i + segments[s].to_end};
    const uint k = kept[i];
    const uint origin = origins[i] - 1u;
    __global int* own = memory + LA_MEMORY_WORDS * (origin >> 1);
    for (uint end = 0; end < 2; ++end) {
        const int offset = kept[i + 1] != k ? settled_offset(tables, k, end, args.limit)
                                            : filled_offset(tables, k, i, end, args.limit);
        const int coordinate = (int)(lengths[i + end] - lengths[chain]) + offset;
        carried[2 * i + end] = coordinate;
        own[end == 0 ? LA_MEMORY_START : LA_MEMORY_END] = coordinate;
    }
    const bool drawn = is_drawn(arcs, s);
    own[LA_MEMORY_RANGE] = drawn ? (int)packed_range(clipped + s) : 0;
    own[LA_MEMORY_STAMP] = drawn ? (int)(args.frame << 1 | (origin & 1u)) : 0;
}

/* The coordinate at a share of a segment. Beyond the ends it grows by one per pixel. */
static float coordinate_at(const float start, const float end, const float length_px,
                           const float share) {
    const float within = clamp(share, 0.0f, 1.0f);
    return start + (end - start) * within + (share - within) * length_px;
}

/* One work-item per run. Runs of silhouettes get the carried coordinates. Their distances to the
 * ends of their strokes stay. */
KERNEL(carry_runs, CarryParameters) {
    const uint r = (uint)get_global_id(0);
    if (r >= args.count || r >= record->points[0]) return;
    __global Run* run = runs + r;
    if (run->segment < args.first) return;
    const uint i = run->segment - args.first;
    const float unit = 1.0f / LA_ARC_UNITS_PER_PIXEL;
    const float start = (float)carried[2 * i] * unit, end = (float)carried[2 * i + 1] * unit;
    const float length_px = arc_pixels(arcs[run->segment + 1] - arcs[run->segment]);
    const float samples = (float)run->samples;
    const float start_arc = coordinate_at(start, end, length_px, run->start_sample / samples);
    const float end_arc = coordinate_at(start, end, length_px, run->end_sample / samples);
    run->stroke_start += start_arc - run->start_arc;
    run->stroke_end += end_arc - run->end_arc;
    run->start_arc = start_arc;
    run->end_arc = end_arc;
}
