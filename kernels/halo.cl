/* halo: gaps in lines where nearer lines cross them (§4.5; Appel, Rohlf and Stein 1979).
 *
 * Runs are listed by the tiles of the picture that they pass: counted, `scan`, filled in. Each run
 * is then tested against the lists of its own tiles. Lists are in no particular order, and a pair
 * that shares several tiles is found several times: the cuts of a run are kept as a sorted set.
 *
 * Work-items take runs in turns: how many there are is known on the device alone. */

#include "segment_table.h"

#pragma OPENCL FP_CONTRACT OFF

/* Tiles are found with this many pixels to spare, more than rounding can take away. */
#define SLACK 0.125f
#define BEYOND_PICTURE 1e9f

/* What a tile's list holds of a run. */
typedef struct Passing {
    float ends[4]; /* x, y of both, lengthened */
    uint run;
} Passing;

static float2 run_way(__global const Run* run) {
    return vload2(0, run->end) - vload2(0, run->start);
}

static float length_of(const float2 way) {
    return sqrt(way.x * way.x + way.y * way.y);
}

/* Both ends of a run, lengthened by so many pixels. Its own length must be above 0. */
static float4 lengthened(__global const Run* run, const float at_start, const float at_end) {
    const float2 way = run_way(run);
    const float2 along = way / length_of(way);
    return (float4)(vload2(0, run->start) - along * at_start, vload2(0, run->end) + along * at_end);
}

static int tile_of(const float pixels, const int count) {
    return clamp(convert_int_rtn(pixels * (1.0f / LA_HALO_TILE)), 0, count - 1);
}

/* The first and last row of tiles that a line passes. What lies outside the picture belongs to the
 * tiles at its border. */
static int2 rows_of(const float4 line, const int2 tiles) {
    return (int2)(tile_of(fmin(line.y, line.w) - SLACK, tiles.y),
                  tile_of(fmax(line.y, line.w) + SLACK, tiles.y));
}

/* The first and last tile of a row that it passes. */
static int2 columns_of(const float4 line, const int row, const int2 tiles) {
    const float2 way = line.zw - line.xy;
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
    return (int2)(tile_of(fmin(x0, x1) - SLACK, tiles.x), tile_of(fmax(x0, x1) + SLACK, tiles.x));
}

static bool has_length(__global const Run* run) {
    const float2 way = run_way(run);
    return way.x != 0.0f || way.y != 0.0f;
}

/* counts[t], zero before: runs that pass tile t. */
__kernel void halo_count(__global const Run* restrict runs,
                         __global const FrameRecord* restrict record, const int2 tiles,
                         __global uint* restrict counts) {
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

/* ends[t]: where the list of tile t starts; afterwards where it ends, which is where the next one
 * starts. */
__kernel void halo_fill(__global const Run* restrict runs,
                        __global const FrameRecord* restrict record, const int2 tiles,
                        __global uint* restrict ends, __global Passing* restrict lists) {
    const uint count = record->points[0];
    for (uint r = (uint)get_global_id(0); r < count; r += (uint)get_global_size(0)) {
        if (!has_length(runs + r)) continue;
        const float4 line = lengthened(runs + r, LA_HALO_REACH_OVER, LA_HALO_REACH_OVER);
        const int2 rows = rows_of(line, tiles);
        for (int y = rows.x; y <= rows.y; ++y) {
            const int2 columns = columns_of(line, y, tiles);
            for (int x = columns.x; x <= columns.y; ++x) {
                __global Passing* passing = lists + atomic_inc(ends + y * tiles.x + x);
                vstore4(line, 0, passing->ends);
                passing->run = r;
            }
        }
    }
}

/* Where two lines cross: shares of their ways, and the sine of the angle between them. */
typedef struct Crossing {
    float on_r, on_c, sine;
} Crossing;

static bool find_crossing(const float4 r, const float length_r, const float4 c, Crossing* found) {
    const float2 way_r = r.zw - r.xy;
    const float2 way_c = c.zw - c.xy;
    const float2 between = c.xy - r.xy;
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

/* Whether two segments meet in a vertex or follow one another in a path. */
static bool are_neighbours(__global const Segment* segments, const uint i, const uint j) {
    if (i == j) return true;
    const Segment a = segments[i], b = segments[j];
    if (a.p == b.p || a.p == b.q || a.q == b.p || a.q == b.q) return true;
    if (a.path != b.path) return false;
    const uint apart = i > j ? i - j : j - i;
    return apart == 1 || ((a.tag & LA_TAG_CLOSED) != 0 && apart == a.from_start + a.to_end);
}

/* 1/w at a share of a run's way; linear on the screen along its segment. */
static float inverse_w(__global const Run* run, __global const ClippedSegment* segment,
                       const float share) {
    const float sample = run->start_sample + (run->end_sample - run->start_sample) * share;
    const float u = clamp(sample / (float)run->samples, 0.0f, 1.0f);
    const float at_p = 1.0f / segment->p[3];
    return at_p + (1.0f / segment->q[3] - at_p) * u;
}

/* The LA_MOST_CUTS first of the cuts found, by `from` and then `to`, none twice. */
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

/* cuts[r]: the gaps of run r. width: from the middle of the nearer stroke to the end of the gap.
 * tolerance: in window depth, times w. */
__kernel void halo_cut(__global const Segment* restrict segments,
                       __global const ClippedSegment* restrict clipped,
                       __global const Run* restrict runs,
                       __global const FrameRecord* restrict record, const int2 tiles,
                       const float width, const float tolerance, __global const uint* restrict ends,
                       __global const Passing* restrict lists, __global RunCuts* restrict cuts) {
    const uint count = record->points[0];
    for (uint r = (uint)get_global_id(0); r < count; r += (uint)get_global_size(0)) {
        __global const Run* run = runs + r;
        Cuts found;
        found.count = 0;
        if (has_length(run)) {
            const uint start_kind = (run->flags >> LA_RUN_START_SHIFT) & LA_END_MASK;
            const uint end_kind = (run->flags >> LA_RUN_END_SHIFT) & LA_END_MASK;
            const float before = start_kind == LA_END_HIDDEN ? LA_HALO_REACH_HIDDEN : 0.0f;
            const float after = end_kind == LA_END_HIDDEN ? LA_HALO_REACH_HIDDEN : 0.0f;
            const float4 line = lengthened(run, before, after);
            const float own_length = length_of(run_way(run));
            const float line_length = length_of(line.zw - line.xy);
            const int2 rows = rows_of(line, tiles);
            for (int y = rows.x; y <= rows.y; ++y) {
                const int2 columns = columns_of(line, y, tiles);
                const int first = y * tiles.x + columns.x, last = y * tiles.x + columns.y;
                const uint end = ends[last];
                for (uint k = first > 0 ? ends[first - 1] : 0; k < end; ++k) {
                    Crossing crossing;
                    const float4 other_line = vload4(0, lists[k].ends);
                    if (!find_crossing(line, line_length, other_line, &crossing)) continue;
                    __global const Run* other = runs + lists[k].run;
                    const float at = crossing.on_r * line_length - before; /* from start */
                    const float share = at / own_length;
                    const float other_at =
                        crossing.on_c * length_of(other_line.zw - other_line.xy) -
                        LA_HALO_REACH_OVER;
                    const float other_share =
                        clamp(other_at / length_of(run_way(other)), 0.0f, 1.0f);
                    const float depth =
                        run->start_depth + (run->end_depth - run->start_depth) * share;
                    const float other_depth =
                        other->start_depth + (other->end_depth - other->start_depth) * other_share;
                    const float apart = tolerance * inverse_w(run, clipped + run->segment, share) +
                                        LA_DEPTH_ROUNDING;
                    if (!(other_depth < depth - 2.0f * apart)) continue;
                    if (are_neighbours(segments, run->segment, other->segment)) continue;
                    const float half_gap = fmin(width / crossing.sine, LA_HALO_STRETCH * width);
                    const float centre = run->start_arc + at;
                    add_cut(&found, centre - half_gap, centre + half_gap);
                }
            }
        }
        for (uint k = 0; k < LA_MOST_CUTS; ++k) {
            cuts[r].from[k] = k < found.count ? found.from[k] : 0.0f;
            cuts[r].to[k] = k < found.count ? found.to[k] : 0.0f;
        }
    }
}
