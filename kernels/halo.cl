/* halo: gaps in lines where nearer lines cross them (§4.5; Appel, Rohlf and Stein 1979).
 *
 * Runs are listed by the tiles of the picture that they pass: counted, `scan`, filled in. Each run
 * is then tested against the lists of its own tiles. Lists are in no particular order, and a pair
 * of runs that shares several tiles is found several times. So the cuts of a run are kept as a
 * sorted set.
 *
 * Work-items take runs in turns, because the number of runs is known only on the device.
 *
 * HALO_LANES: how many lines of a list are tested at once, 1 on GPUs. */

#include "kernels.h"
#include "shared/run.h"

/* Pixels to spare when tiles are found, more than rounding can take away. */
#define SLACK 0.125f
#define BEYOND_PICTURE 1e9f
/* Depth to spare in the first, rough comparison, more than rounding can take away. */
#define DEPTH_SLACK 2e-6f

#define LANES HALO_LANES
#include "shared/lanes.h"

/* The lists of tiles, a table per number: the ends of a run, lengthened, their depths, and the
 * run's index. Each table has room for HALO_LANES more, because rows are read beyond a list's end.
 */
typedef struct Lists {
    __global float *x0, *y0, *x1, *y1, *depth0, *depth1;
    __global uint* run;
} Lists;

static Lists lists_in(__global float* memory, const uint total) {
    const size_t pitch = (size_t)total + HALO_LANES;
    const Lists lists = {memory,
                         memory + pitch,
                         memory + 2 * pitch,
                         memory + 3 * pitch,
                         memory + 4 * pitch,
                         memory + 5 * pitch,
                         (__global uint*)(memory + 6 * pitch)};
    return lists;
}

static float2 run_way(__global const Run* run) {
    return vload2(0, run->end) - vload2(0, run->start);
}

static float length_of(const float2 way) {
    return sqrt(way.x * way.x + way.y * way.y);
}

/* Both ends of a run that is lengthened by so many pixels at either end. The run's own length must
 * be above 0. */
static float4 lengthened(__global const Run* run, const float at_start, const float at_end) {
    const float2 way = run_way(run);
    const float2 along = way / length_of(way);
    const float2 start = vload2(0, run->start) - along * at_start;
    const float2 end = vload2(0, run->end) + along * at_end;
    return float4(start.x, start.y, end.x, end.y);
}

static int tile_of(const float pixels, const int count) {
    return clamp(convert_int_rtn(pixels * (1.0f / LA_HALO_TILE)), 0, count - 1);
}

/* The first and last row of tiles that a line passes. Parts outside the picture belong to the tiles
 * at its border. */
static int2 rows_of(const float4 line, const int2 tiles) {
    return int2(tile_of(fmin(line.y, line.w) - SLACK, tiles.y),
                tile_of(fmax(line.y, line.w) + SLACK, tiles.y));
}

/* The first and last tile of a row that a line passes. */
static int2 columns_of(const float4 line, const int row, const int2 tiles) {
    const float2 way = zw(line) - xy(line);
    float u0 = 0.0f, u1 = 1.0f;
    if (fabs(way.y) > SLACK) {
        const float low = row == 0 ? -BEYOND_PICTURE : (float)(row * LA_HALO_TILE) - SLACK;
        const float high =
            row == tiles.y - 1 ? BEYOND_PICTURE : (float)((row + 1) * LA_HALO_TILE) + SLACK;
        const float u_low = clamp((low - line.y) / way.y, 0.0f, 1.0f);
        const float u_high = clamp((high - line.y) / way.y, 0.0f, 1.0f);
        u0 = fmin(u_low, u_high);
        u1 = fmax(u_low, u_high);
    }
    const float x0 = line.x + way.x * u0;
    const float x1 = line.x + way.x * u1;
    return int2(tile_of(fmin(x0, x1) - SLACK, tiles.x), tile_of(fmax(x0, x1) + SLACK, tiles.x));
}

static bool has_length(__global const Run* run) {
    const float2 way = run_way(run);
    return way.x != 0.0f || way.y != 0.0f;
}

/* counts[t]: runs that pass tile t, zero before. */
KERNEL(halo_count, HaloParameters) {
    const int2 tiles = to_int2(args.tiles);
    const uint count = record->points[0];
    for (uint r = (uint)get_global_id(0); r < count; r += (uint)get_global_size(0)) {
        if (!has_length(runs + r)) continue;
        const float4 line = lengthened(runs + r, LA_HALO_REACH_OVER, LA_HALO_REACH_OVER);
        const int2 rows = rows_of(line, tiles);
        for (int y = rows.x; y <= rows.y; ++y) {
            const int2 columns = columns_of(line, y, tiles);
            for (int x = columns.x; x <= columns.y; ++x) atomic_inc(counts + y * tiles.x + x);
        }
    }
}

/* Window depths at both ends of a run that is lengthened by LA_HALO_REACH_OVER. Beyond its ends a
 * run counts as deep as its end is. The line between the two depths is nowhere farther away than
 * that. */
static float2 nearest_depths(__global const Run* run) {
    const float2 own = float2(run->start_depth, run->end_depth);
    const float length = length_of(run_way(run));
    const float nearer = fmin(own.x, own.y);
    if (length < LA_HALO_REACH_OVER) return float2(nearer, nearer);
    const float over = (own.y - own.x) / length * LA_HALO_REACH_OVER;
    return float2(own.x - over, own.y + over) - fabs(over);
}

/* ends[t]: where the list of tile t starts. The kernel changes it to where the list ends and the
 * next one starts. */
KERNEL(halo_fill, HaloParameters) {
    const int2 tiles = to_int2(args.tiles);
    const uint count = record->points[0];
    const Lists lists = lists_in(memory, args.total);
    for (uint r = (uint)get_global_id(0); r < count; r += (uint)get_global_size(0)) {
        if (!has_length(runs + r)) continue;
        const float4 line = lengthened(runs + r, LA_HALO_REACH_OVER, LA_HALO_REACH_OVER);
        const float2 depths = nearest_depths(runs + r);
        const int2 rows = rows_of(line, tiles);
        for (int y = rows.x; y <= rows.y; ++y) {
            const int2 columns = columns_of(line, y, tiles);
            for (int x = columns.x; x <= columns.y; ++x) {
                const uint k = atomic_inc(ends + y * tiles.x + x);
                lists.x0[k] = line.x;
                lists.y0[k] = line.y;
                lists.x1[k] = line.z;
                lists.y1[k] = line.w;
                lists.depth0[k] = depths.x;
                lists.depth1[k] = depths.y;
                lists.run[k] = r;
            }
        }
    }
}

/* Where two lines cross: shares of their ways, and the sine of the angle between them. */
typedef struct Crossing {
    float on_r, on_c, sine;
} Crossing;

static bool find_crossing(const float4 r, const float length_r, const float4 c, Crossing* found) {
    const float2 way_r = zw(r) - xy(r);
    const float2 way_c = zw(c) - xy(c);
    const float2 between = xy(c) - xy(r);
    const float area = way_r.x * way_c.y - way_r.y * way_c.x;
    const float sign = area < 0.0f ? -1.0f : 1.0f;
    const float along_r = (between.x * way_c.y - between.y * way_c.x) * sign;
    const float along_c = (between.x * way_r.y - between.y * way_r.x) * sign;
    const float size = area * sign;
    if (along_r < 0.0f || along_r > size || along_c < 0.0f || along_c > size) return false;
    found->sine = size / (length_r * length_of(way_c));
    if (!(found->sine >= LA_HALO_LEAST_SINE)) return false;
    found->on_r = along_r / size;
    found->on_c = along_c / size;
    return true;
}

/* A run, with the numbers that other runs are tested against. */
typedef struct Subject {
    __global const Run* run;
    float4 line; /* lengthened by `before` at its start */
    float before, length, own_length;
    float2 farthest; /* depths at both ends of `line`; a run before them may cut it */
} Subject;

/* Lanes of the lines, from k on in the lists, that cross the subject and may lie far enough before
 * it. Most lines that cross it are neighbours at its own depth, which need not be looked at one by
 * one. */
static lanes_int may_cut(const Subject subject, const Lists lists, const uint k) {
    const float4 r = subject.line;
    const float2 way_r = zw(r) - xy(r);
    const lanes_float x0 = LOAD_LANES(lists.x0 + k), y0 = LOAD_LANES(lists.y0 + k);
    const lanes_float way_x = LOAD_LANES(lists.x1 + k) - x0, way_y = LOAD_LANES(lists.y1 + k) - y0;
    const lanes_float between_x = x0 - r.x, between_y = y0 - r.y;
    const lanes_float area = way_r.x * way_y - way_r.y * way_x;
    const lanes_float sign = copysign((lanes_float)(1.0f), area);
    const lanes_float along_r = (between_x * way_y - between_y * way_x) * sign;
    const lanes_float along_c = (between_x * way_r.y - between_y * way_r.x) * sign;
    const lanes_float size = area * sign;
    const lanes_float depth0 = LOAD_LANES(lists.depth0 + k);
    const lanes_float deeper = LOAD_LANES(lists.depth1 + k) - depth0;
    const float farther = subject.farthest.y - subject.farthest.x;
    /* Depths at the crossing, both times `size`. */
    const lanes_float other = depth0 * size + deeper * along_c;
    const lanes_float own = subject.farthest.x * size + farther * along_r;
    return fmin(along_r, along_c) >= 0.0f && fmax(along_r, along_c) <= size && other <= own;
}

/* Whether two segments meet in a vertex or follow one another in a path. */
static bool are_neighbours(__global const Segment* segments, const uint i, const uint j) {
    if (i == j) return true;
    const Segment a = segments[i], b = segments[j];
    if (a.p == b.p || a.p == b.q || a.q == b.p || a.q == b.q) return true;
    if (a.path != b.path) return false;
    const uint apart = i > j ? i - j : j - i;
    return apart == 1 || ((a.tag & LA_TAG_CLOSED) != 0 && apart == a.from_start + a.to_end);
}

/* 1/w at a share of a run's way. It is linear on the screen along the segment. */
static float inverse_w(__global const Run* run, __global const ClippedSegment* segment,
                       const float share) {
    const float sample = run->start_sample + (run->end_sample - run->start_sample) * share;
    const float u = clamp(sample / (float)run->samples, 0.0f, 1.0f);
    const float at_p = 1.0f / segment->p[3];
    return at_p + (1.0f / segment->q[3] - at_p) * u;
}

/* The first LA_MOST_CUTS of the cuts found, in the order of `from` and then `to`, none twice. */
typedef struct Cuts {
    float from[LA_MOST_CUTS], to[LA_MOST_CUTS];
    uint count;
} Cuts;

static void add_cut(Cuts* cuts, float from, float to) {
    for (uint k = 0; k < cuts->count; ++k) {
        const float other_from = cuts->from[k], other_to = cuts->to[k];
        if (from == other_from && to == other_to) return;
        if (from < other_from || (from == other_from && to < other_to)) {
            cuts->from[k] = from;
            cuts->to[k] = to;
            from = other_from;
            to = other_to;
        }
    }
    if (cuts->count == LA_MOST_CUTS) return;
    cuts->from[cuts->count] = from;
    cuts->to[cuts->count] = to;
    ++cuts->count;
}

/* The tables and numbers that all runs are tested with. */
typedef struct Scene {
    __global const Segment* segments;
    __global const ClippedSegment* clipped;
    __global const Run* runs;
    uint run_count;
    float width, tolerance;
} Scene;

/* Adds the gap that run c, lengthened to `line`, leaves in the subject, if any. */
static void add_cut_of(const Scene scene, const Subject subject, const float4 line, const uint c,
                       Cuts* cuts) {
    Crossing crossing;
    if (!find_crossing(subject.line, subject.length, line, &crossing)) return;
    __global const Run* run = subject.run;
    const float at = crossing.on_r * subject.length - subject.before; /* from the run's start */
    const float centre = run->start_arc + at;
    const float stretch =
        fmin(1.0f / crossing.sine, LA_HALO_STRETCH * LA_HALO_STRETCH * crossing.sine);
    const float half_gap = scene.width * stretch;
    /* Among dense lines most cuts come too late. Then the depth need not be looked at. */
    if (cuts->count == LA_MOST_CUTS && centre - half_gap > cuts->from[LA_MOST_CUTS - 1]) return;
    __global const Run* other = scene.runs + c;
    const float share = at / subject.own_length;
    const float other_at = crossing.on_c * length_of(zw(line) - xy(line)) - LA_HALO_REACH_OVER;
    const float other_share = clamp(other_at / length_of(run_way(other)), 0.0f, 1.0f);
    const float depth = run->start_depth + (run->end_depth - run->start_depth) * share;
    const float other_depth =
        other->start_depth + (other->end_depth - other->start_depth) * other_share;
    if (!(other_depth < depth)) return; /* before 1/w is computed */
    const float apart =
        scene.tolerance * inverse_w(run, scene.clipped + run->segment, share) + LA_DEPTH_ROUNDING;
    if (!(other_depth < depth - 2.0f * apart)) return;
    if (are_neighbours(scene.segments, run->segment, other->segment)) return;
    add_cut(cuts, centre - half_gap, centre + half_gap);
}

/* All gaps of a run that has length. */
static void find_cuts(const Scene scene, __global const Run* run, const int2 tiles,
                      __global const uint* ends, const Lists lists, Cuts* cuts) {
    const uint r = (uint)(run - scene.runs);
    const bool hidden_before = !shown_across(scene.segments, scene.runs, scene.run_count, r, false);
    const bool hidden_after = !shown_across(scene.segments, scene.runs, scene.run_count, r, true);
    Subject subject;
    subject.run = run;
    subject.before = hidden_before ? LA_HALO_REACH_HIDDEN : 0.0f;
    const float after = hidden_after ? LA_HALO_REACH_HIDDEN : 0.0f;
    subject.line = lengthened(run, subject.before, after);
    subject.length = length_of(zw(subject.line) - xy(subject.line));
    subject.own_length = length_of(run_way(run));
    __global const ClippedSegment* clipped = scene.clipped + run->segment;
    const float least_apart =
        scene.tolerance * (1.0f / fmax(clipped->p[3], clipped->q[3])) + LA_DEPTH_ROUNDING;
    const float deeper = (run->end_depth - run->start_depth) / subject.own_length; /* per pixel */
    subject.farthest =
        float2(run->start_depth - deeper * subject.before, run->end_depth + deeper * after) -
        2.0f * least_apart + DEPTH_SLACK;
    const int2 rows = rows_of(subject.line, tiles);
    for (int y = rows.x; y <= rows.y; ++y) {
        const int2 columns = columns_of(subject.line, y, tiles);
        const int first = y * tiles.x + columns.x; /* lists of neighbouring tiles in a row adjoin */
        const uint end = ends[y * tiles.x + columns.y];
        for (uint k = first > 0 ? ends[first - 1] : 0; k < end; k += HALO_LANES) {
            const lanes_int crosses = may_cut(subject, lists, k);
            if (!ANY(crosses)) continue;
            int mask[HALO_LANES];
            STORE_LANES(crosses, mask);
            for (uint i = k; i < min(k + HALO_LANES, end); ++i) {
                if (mask[i - k] == 0) continue;
                const float4 line = float4(lists.x0[i], lists.y0[i], lists.x1[i], lists.y1[i]);
                add_cut_of(scene, subject, line, lists.run[i], cuts);
            }
        }
    }
}

/* cuts[r]: the gaps of run r. */
KERNEL(halo_cut, HaloParameters) {
    const int2 tiles = to_int2(args.tiles);
    const uint count = record->points[0];
    const Lists lists = lists_in(memory, args.total);
    const Scene scene = {segments, clipped, runs, count, args.width, args.tolerance};
    for (uint r = (uint)get_global_id(0); r < count; r += (uint)get_global_size(0)) {
        Cuts found;
        found.count = 0;
        if (has_length(runs + r)) find_cuts(scene, runs + r, tiles, ends, lists, &found);
        for (uint k = 0; k < LA_MOST_CUTS; ++k) {
            cuts[r].from[k] = k < found.count ? found.from[k] : 0.0f;
            cuts[r].to[k] = k < found.count ? found.to[k] : 0.0f;
        }
    }
}
