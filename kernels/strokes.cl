/* strokes: the visible runs as coverage of the picture's pixels, the compute form (§4.4, §4.5).
 *
 * Runs are listed by the tiles of the picture that they touch, in their order: counted per tile
 * and chunk of runs, `scan`, listed. Then every tile is drawn: one run over the other, as GL would.
 * The result is a byte of coverage per pixel and pen; all strokes of a pen have one colour.
 *
 * strokes_count, strokes_list: one work-item per chunk. strokes_tiles: one work-item per tile,
 * which it keeps in local memory. On a GPU (Tuning::stroke_pixels) two kernels replace
 * strokes_tiles: strokes_boxes, one work-item per run, and strokes_pixels, one per DEPTH_LANES
 * pixels. */

#define LANES DEPTH_LANES
#include "stroke.h"

/* Tiles are found with this many pixels to spare, more than rounding can take away. */
#define SLACK 0.125f

static int stroke_tile(const float pixels) {
    return convert_int_rtn(pixels * (1.0f / LA_STROKE_TILE));
}

/* How far a run may reach from one end's position along x and y: coverage is 0 beyond. */
static float2 reach_of(__global const float* corner, const uint kind, const float reach) {
    /* From the spine across and beyond the end, whatever its direction. */
    const float all = 1.4143f * reach;
    if (kind != LA_END_JOIN) return float2(all + SLACK, all + SLACK);
    return float2(fmax(fabs(corner[0]) * reach, reach) + SLACK,
                  fmax(fabs(corner[1]) * reach, reach) + SLACK);
}

/* Enters a run into its tiles: counts it, or writes it at the place in `ends`, which the function
 * moves on. */
static void enter(const StrokeListParameters* args, __global const Run* run, const uint r,
                  const uint chunk, __global uint* ends, __global uint* entries) {
    const float2 a = vload2(0, run->start), b = vload2(0, run->end);
    const float2 at_start =
        reach_of(run->start_corner, end_kind(run->flags, LA_RUN_START_SHIFT), args->reach);
    const float2 at_end =
        reach_of(run->end_corner, end_kind(run->flags, LA_RUN_END_SHIFT), args->reach);
    const float2 low = fmin(a - at_start, b - at_end), high = fmax(a + at_start, b + at_end);
    const int2 tiles = to_int2(args->tiles);
    const int left = max(stroke_tile(low.x), 0), right = min(stroke_tile(high.x), tiles.x - 1);
    const int below = max(stroke_tile(low.y), 0), above = min(stroke_tile(high.y), tiles.y - 1);
    const bool is_long = right - left > 1 && above - below > 1;
    const float2 way = b - a, reach = fmax(at_start, at_end);
    for (int row = below; row <= above; ++row) {
        int first = left, last = right;
        if (is_long) {
            const float y0 = (float)(row * LA_STROKE_TILE) - reach.y;
            const float y1 = (float)((row + 1) * LA_STROKE_TILE) + reach.y;
            const float u0 = clamp((y0 - a.y) / way.y, 0.0f, 1.0f);
            const float u1 = clamp((y1 - a.y) / way.y, 0.0f, 1.0f);
            const float x0 = a.x + way.x * u0, x1 = a.x + way.x * u1;
            first = max(first, stroke_tile(fmin(x0, x1) - reach.x));
            last = min(last, stroke_tile(fmax(x0, x1) + reach.x));
        }
        for (int column = first; column <= last; ++column) {
            __global uint* end = ends + ((uint)(row * tiles.x + column) * args->chunks + chunk);
            if (entries != 0) entries[*end] = r;
            *end += 1u;
        }
    }
}

/* The runs of a chunk. */
static uint2 runs_of(const uint chunk, const uint chunks, const uint count) {
    const uint each = (count + chunks - 1u) / chunks;
    return uint2(min(chunk * each, count), min((chunk + 1u) * each, count));
}

/* counts: per tile, per chunk; all 0 before. */
KERNEL(strokes_count, StrokeListParameters) {
    const uint chunk = (uint)get_global_id(0);
    if (chunk >= args.chunks) return;
    const uint2 own = runs_of(chunk, args.chunks, record->points[0]);
    for (uint r = own.x; r < own.y; ++r) enter(&args, runs + r, r, chunk, counts, 0);
}

/* ends: the scanned counts, and behind them the number of all entries. Afterwards each says where
 * its part of the list ends. total: the number of all entries. If there are more than fit, nothing
 * is written or drawn. The host reads the total, enlarges the table and does the frame again. */
KERNEL(strokes_list, StrokeListParameters) {
    const uint chunk = (uint)get_global_id(0);
    if (chunk >= args.chunks) return;
    const uint all = ends[(uint)(args.tiles.v[0] * args.tiles.v[1]) * args.chunks];
    if (chunk == 0) total[0] = all;
    if (all > args.capacity) return;
    const uint2 own = runs_of(chunk, args.chunks, record->points[0]);
    for (uint r = own.x; r < own.y; ++r) enter(&args, runs + r, r, chunk, ends, entries);
}

/* What of the list of tile t is to be drawn. */
static uint2 list_of(const StrokesParameters* args, const uint t, __global const uint* ends) {
    const uint all = (uint)(args->tiles.v[0] * args->tiles.v[1]) * args->chunks;
    if (ends[all] > args->capacity) return uint2(0, 0);
    const uint first = t > 0 ? ends[t * args->chunks - 1u] : 0;
    const uint count = ends[(t + 1u) * args->chunks - 1u] - first;
    return uint2(first + min(args->begin, count), first + min(args->end, count));
}

static bool is_drawn(const StrokesParameters* args, __global const Run* run) {
    return args->pen == LA_ALL_PENS ||
           (run->flags >> LA_RUN_PEN_SHIFT & LA_RUN_PEN_MASK) == args->pen;
}

#define STROKE_STRIDE (LA_STROKE_TILE + LANES)

/* A stroke covers no pixels but those whose numbers are above xy and up to zw. */
static float4 bounds_of(const Stroke* s) {
    const float2 beyond = s->along * s->before, after = s->along * s->after;
    const float2 a = s->start_side * s->reach, b = s->end_side * s->reach;
    const float2 p = s->start - beyond, q = s->end + after;
    const float2 low = fmin(fmin(p - a, p + a), fmin(q - b, q + b)) - (0.5f + SLACK);
    const float2 high = fmax(fmax(p - a, p + a), fmax(q - b, q + b)) - (0.5f - SLACK);
    return float4(low.x, low.y, high.x, high.y);
}

/* The pixels of a tile from corner on that a stroke may cover: from xy to zw, inclusive. */
static int4 box_of(const Stroke* s, const int2 corner, const int4 within) {
    const float4 bounds = bounds_of(s);
    return int4(max(convert_int_rtn(bounds.x) - corner.x + 1, within.x),
                max(convert_int_rtn(bounds.y) - corner.y + 1, within.y),
                min(convert_int_rtn(bounds.z) - corner.x, within.z),
                min(convert_int_rtn(bounds.w) - corner.y, within.w));
}

/* Draws a stroke into a tile. `rounds`, `rest`: as in coverage_at. */
INLINED void draw_rows(const StrokesParameters* args, const Stroke* s, __local float* pixels,
                       const int2 corner, const int4 box, const bool rounds, const bool rest,
                       __global const uchar* own, __global const float* mark,
                       __global const float* weights) {
    /* If the spine is steep enough, only the part of a row in the strip around it is looked at. */
    const bool is_steep = fabs(s->along.y) > 0.0625f && box.z - box.x >= LANES;
    const float slope = is_steep ? s->along.x / s->along.y : 0.0f;
    const float aside = is_steep ? s->reach / fabs(s->along.y) + 1.0f : 0.0f;
    const lanes_float lane = TO_FLOAT((lanes_int)LANE_INDEX) + 0.5f;
    for (int row = box.y; row <= box.w; ++row) {
        const float y = (float)(corner.y + row) + 0.5f;
        int first = box.x, last = box.z;
        if (is_steep) {
            const float middle = s->start.x + (y - s->start.y) * slope - (float)corner.x - 0.5f;
            first = max(first, convert_int_rtn(clamp(middle - aside, -1.0f, 4096.0f)) + 1);
            last = min(last, convert_int_rtn(clamp(middle + aside, -1.0f, 4096.0f)));
        }
        __local float* to = pixels + row * STROKE_STRIDE;
        for (int column = first; column <= last; column += LANES) {
            const lanes_float x = lane + (float)(corner.x + column);
            const lanes_float covered =
                coverage_at(args, s, x, y, rounds, rest, own, mark, weights);
            const lanes_float below = LOAD_LANES(to + column);
            STORE_LANES(over(below, covered), to + column);
        }
    }
}

INLINED void draw_stroke(const StrokesParameters* args, __global const Run* run,
                         __local float* pixels, const int2 corner, const int4 within,
                         __global const uchar* alpha, __global const float* mark,
                         __global const float* weights) {
    Stroke s;
    make_stroke(args, run, alpha, weights, &s);
    __global const uchar* own = alpha + run->address;
    const int4 box = box_of(&s, corner, within);
    if (!s.is_even || s.has_cut || s.is_marked || s.is_thinned)
        draw_rows(args, &s, pixels, corner, box, true, true, own, mark, weights);
    else if (s.has_round)
        draw_rows(args, &s, pixels, corner, box, true, false, own, mark, weights);
    else
        draw_rows(args, &s, pixels, corner, box, false, false, own, mark, weights);
}

/* coverage: for each layer a byte per pixel of the part, row by row. shown: for each layer 1 for
 * every tile of the part that may be covered, else 0. */
KERNEL(strokes_tiles, StrokesParameters) {
    LOCAL_TABLE(float, pixels, STROKE_STRIDE* LA_STROKE_TILE);
    const int2 columns = to_int2(args.columns), tiles = to_int2(args.tiles);
    const uint t = (uint)get_global_id(0);
    if (t >= (uint)(columns.x * columns.y)) return;
    const int2 place = to_int2(args.first) + int2((int)t % columns.x, (int)t / columns.x);
    const uint2 list = list_of(&args, (uint)(place.y * tiles.x + place.x), ends);
    if (list.x == list.y && args.again != 0) return;
    const int4 part = to_int4(args.part);
    const int2 corner = place * LA_STROKE_TILE;
    /* Of the tile, those pixels that the part has. */
    const int4 within = int4(max(part.x - corner.x, 0), max(part.y - corner.y, 0),
                             min(part.x + part.z - corner.x, LA_STROKE_TILE) - 1,
                             min(part.y + part.w - corner.y, LA_STROKE_TILE) - 1);
    for (int i = 0; i < STROKE_STRIDE * LA_STROKE_TILE; ++i) pixels[i] = 0.0f;
    __global uchar* own = coverage + (size_t)args.layer * args.pitch +
                          ((corner.y - part.y) * part.z + (corner.x - part.x));
    if (args.again != 0) {
        for (int y = within.y; y <= within.w; ++y) {
            for (int x = within.x; x <= within.z; ++x)
                pixels[y * STROKE_STRIDE + x] = (float)own[y * part.z + x];
        }
    }
    bool any = args.again != 0;
    for (uint i = list.x; i < list.y; ++i) {
        __global const Run* run = runs + entries[i];
        if (!is_drawn(&args, run)) continue;
        any = true;
        draw_stroke(&args, run, pixels, corner, within, alpha, mark, weights);
    }
    for (int y = within.y; y <= within.w; ++y) {
        for (int x = within.x; x <= within.z; ++x)
            own[y * part.z + x] = (uchar)pixels[y * STROKE_STRIDE + x];
    }
    shown[args.layer * (uint)(columns.x * columns.y) + t] = any ? 1 : 0;
}

/* Finds the numbers of each run's stroke that its pixels share. One work-item per run. */
KERNEL(strokes_boxes, StrokesParameters) {
    const uint r = (uint)get_global_id(0);
    if (r >= args.count || r >= record->points[0]) return;
    StrokeBox own = {{0.0f, 0.0f}, {0.0f, 0.0f}, 0, 0.0f};
    if (is_drawn(&args, runs + r)) {
        Stroke s;
        make_stroke(&args, runs + r, alpha, weights, &s);
        const float4 bounds = bounds_of(&s);
        own.low[0] = bounds.x;
        own.low[1] = bounds.y;
        own.high[0] = bounds.z;
        own.high[1] = bounds.w;
        own.flags = LA_STROKE_DRAWN | (s.is_even ? LA_STROKE_EVEN : 0u) |
                    (s.is_thinned ? LA_STROKE_THINNED : 0u);
        own.opacity = s.opacity;
    }
    boxes[r] = own;
}

/* As strokes_tiles. One work-item per LANES pixels of a tile's row. */
KERNEL(strokes_pixels, StrokesParameters) {
    const uint a_row = LA_STROKE_TILE / LANES, each = a_row * LA_STROKE_TILE;
    const uint i = (uint)get_global_id(0);
    const uint t = i / each;
    const int2 columns = to_int2(args.columns), tiles = to_int2(args.tiles);
    if (t >= (uint)(columns.x * columns.y)) return;
    const int2 place = to_int2(args.first) + int2((int)t % columns.x, (int)t / columns.x);
    const uint2 list = list_of(&args, (uint)(place.y * tiles.x + place.x), ends);
    if (list.x == list.y && args.again != 0) return;
    const int4 part = to_int4(args.part);
    const int2 pixel = int2(place.x * LA_STROKE_TILE + (int)(i % a_row) * LANES,
                            place.y * LA_STROKE_TILE + (int)(i % each / a_row));
    const int2 from = pixel - xy(part);
    const int first = max(-from.x, 0), end = min(part.z - from.x, LANES); /* pixels of the part */
    if (first >= end || from.y < 0 || from.y >= part.w) return;
    __global uchar* own = coverage + (size_t)args.layer * args.pitch + from.y * part.z;
    float each_pixel[LANES];
    bool any = args.again != 0;
    for (int k = 0; k < LANES; ++k)
        each_pixel[k] = any && k >= first && k < end ? (float)own[from.x + k] : 0.0f;
    lanes_float covered = LOAD_LANES(each_pixel);
    const float first_column = (float)pixel.x, row = (float)pixel.y;
    const lanes_float x = (TO_FLOAT((lanes_int)LANE_INDEX) + 0.5f) + first_column;
    for (uint k = list.x; k < list.y; ++k) {
        const uint r = entries[k];
        const StrokeBox box = boxes[r];
        if (box.flags == 0) continue;
        any = true;
        if (row <= box.low[1] || row > box.high[1] || first_column > box.high[0] ||
            first_column + (float)(LANES - 1) <= box.low[0])
            continue;
        Stroke s;
        make_known_stroke(&args, runs + r, box, &s);
        covered = over(covered, coverage_at(&args, &s, x, row + 0.5f, true, true,
                                            alpha + runs[r].address, mark, weights));
    }
    STORE_LANES(covered, each_pixel);
    for (int k = first; k < end; ++k) own[from.x + k] = (uchar)each_pixel[k];
    shown[args.layer * (uint)(columns.x * columns.y) + t] = any ? 1 : 0;
}
