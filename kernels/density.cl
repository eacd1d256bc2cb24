/* density: how much of each line is drawn where lines are too many (§4.5, Fig. 11; after Grabli,
 * Durand and Sillion 2004, and Cole et al. 2006).
 *
 * density_lines adds up the drawn length of line per cell of a grid and bin of priority,
 * density_smooth and density_weights smooth these lengths and share the limit out among the bins,
 * first to last. density_excess finds where too much is left, and the limit is shared out again.
 * Lengths are summed as integers, so the order does not matter. A line's length is shared out
 * between cells and bins, so that weights change continuously with the camera, and lines fade and
 * do not pop. */

#include "kernels.h"

/* A run without samples is added up in pieces of this length, pixels. */
#define SOLID_STEP 2.0f

/* The base-2 logarithm of x >= 1, linear between powers of two. It is the same on every device. */
static float rough_log2(const float x) {
    const uint bits = as_uint(x);
    return (float)((bits >> 23) - 127u) + (float)(bits & 0x7FFFFFu) * 0x1p-23f;
}

/* 0 to below 1, the same for a path in every frame (the last steps of MurmurHash3). */
static float chance(uint x) {
    x = (x ^ (x >> 16)) * 0x85EBCA6Bu;
    x = (x ^ (x >> 13)) * 0xC2B2AE35u;
    x ^= x >> 16;
    return (float)(x >> 8) * 0x1p-24f;
}

/* Priority of a line in 1/LA_BIN_STEPS of a bin. Paths of 1,000 pixels and more count as equally
 * long. Chance treats all chains of silhouettes alike: these chains come and go, join and part, and
 * would flash up otherwise. */
static uint priority_of(__global const Segment* segments, __global const uint* arcs, const uint i,
                        const Density density) {
    const uint kind = segments[i].tag & LA_TAG_KIND_MASK;
    const float weights[LA_KIND_COUNT] = {
        density.priority[0], density.priority[1], density.priority[2],  density.priority[3],
        density.priority[4], density.priority[5], density.priority[6],  density.priority[7],
        density.priority[8], density.priority[9], density.priority[10], density.priority[11],
        density.priority[12]};
    const uint first = i - segments[i].from_start;
    const uint units = arcs[i + segments[i].to_end + 1] - arcs[first];
    const float pixels = (float)units * (1.0f / LA_ARC_UNITS_PER_PIXEL);
    const float length = fmin(rough_log2(1.0f + pixels * 0.0625f) * (1.0f / 6.0f), 1.0f);
    const float tie = kind == LA_KIND_SILHOUETTE ? 0.5f : chance(segments[i].path);
    const float priority =
        (LA_PRIORITY_KIND * clamp(weights[kind], 0.0f, 1.0f) + LA_PRIORITY_LENGTH * length) +
        LA_PRIORITY_CHANCE * tie;
    const uint most = (LA_DENSITY_BINS - 1u) * LA_BIN_STEPS;
    return min((uint)(priority * (float)most + 0.5f), most);
}

/* Adds `pixels` of line to one cell. Cells at the border take what falls beside the grid. */
static void add_to_cell(__global uint* grid, const int2 cells, const int x, const int y,
                        const uint priority, const float pixels) {
    const uint units = (uint)(pixels * LA_DENSITY_UNITS_PER_PIXEL + 0.5f);
    if (units == 0) return;
    const uint bin = priority / LA_BIN_STEPS;
    const uint of_next = (uint)((ulong)units * (priority % LA_BIN_STEPS) / LA_BIN_STEPS);
    const uint plane = (uint)(cells.x * cells.y);
    const uint cell = (uint)(clamp(y, 0, cells.y - 1) * cells.x + clamp(x, 0, cells.x - 1));
    atomic_add(grid + bin * plane + cell, units - of_next);
    if (of_next != 0) atomic_add(grid + (bin + 1) * plane + cell, of_next);
}

/* Adds sums, for the four cells around a corner of the grid. */
static void add_to_cells(__global uint* grid, const int2 cells, const int2 low, const uint priority,
                         const float4 sums) {
    add_to_cell(grid, cells, low.x, low.y, priority, sums.x);
    add_to_cell(grid, cells, low.x + 1, low.y, priority, sums.y);
    add_to_cell(grid, cells, low.x, low.y + 1, priority, sums.z);
    add_to_cell(grid, cells, low.x + 1, low.y + 1, priority, sums.w);
}

/* grid: drawn length per bin and cell, zero before. The kernel also sets the priority in the flags
 * of every run. Work-items take runs in turns, because only the device knows how many runs there
 * are. */
KERNEL(density_lines, DensityParameters) {
    const int2 cells = to_int2(args.cells);
    const uint count = record->points[0];
    for (uint r = (uint)get_global_id(0); r < count; r += (uint)get_global_size(0)) {
        __global Run* run = runs + r;
        const uint priority = priority_of(segments, arcs, run->segment, args.density);
        run->flags =
            (run->flags & ~(LA_RUN_BIN_MASK << LA_RUN_BIN_SHIFT)) | priority << LA_RUN_BIN_SHIFT;

        const float2 start = vload2(0, run->start);
        const float2 way = vload2(0, run->end) - start;
        const float length = sqrt(way.x * way.x + way.y * way.y);
        const bool solid = (run->flags & LA_RUN_SOLID) != 0;
        const float first = solid ? 0.0f : run->start_sample;
        const float last = solid ? length * (1.0f / SOLID_STEP) : run->end_sample;
        if (!(length > 0.0f) || !(last > first)) continue;
        const float per_sample = length / (last - first);
        __global const uchar* own = alpha + (solid ? 0 : run->address);
        const int last_own = (int)run->samples - 1;
        const int end = convert_int_rtp(last);
        int2 low = int2(0, 0);
        float4 sums = float4(0.0f, 0.0f, 0.0f, 0.0f);
        for (int j = convert_int_rtn(first); j < end; ++j) {
            const float visible =
                solid ? 1.0f
                      : fmin((float)own[clamp(j, 0, last_own)] * (1.0f / LA_FULLY_SHOWN), 1.0f);
            const float opacity = args.hidden != 0 && !solid ? 1.0f - visible : visible;
            if (opacity == 0.0f) continue;
            const float from = fmax((float)j, first);
            const float to = fmin((float)(j + 1), last);
            const float drawn = (to - from) * per_sample * opacity;
            const float share = ((from + to) * 0.5f - first) / (last - first);
            const float2 place = (start + way * share) * args.per_cell - 0.5f;
            const float2 corner = floor(place);
            const float2 up = place - corner, down = 1.0f - up;
            const int2 here = convert_int2(corner);
            if (here.x != low.x || here.y != low.y) {
                add_to_cells(grid, cells, low, priority, sums);
                low = here;
                sums = float4(0.0f, 0.0f, 0.0f, 0.0f);
            }
            sums += drawn * float4(down.x * down.y, up.x * down.y, down.x * up.y, up.x * up.y);
        }
        add_to_cells(grid, cells, low, priority, sums);
    }
}

/* A tent over five neighbours. Beyond the border its cells are repeated. */
static uint tent(__global const uint* row, const int at, const int stride, const int count) {
    const int last = count - 1;
    return row[max(at - 2, 0) * stride] + 2u * row[max(at - 1, 0) * stride] +
           3u * row[at * stride] + 2u * row[min(at + 1, last) * stride] +
           row[min(at + 2, last) * stride];
}

/* The tent along the rows of all planes. */
KERNEL(density_smooth, DensityParameters) {
    const int2 cells = to_int2(args.cells);
    const int rows = (int)LA_DENSITY_BINS * cells.y;
    const int i = (int)get_global_id(0);
    if (i >= rows * cells.x) return;
    const int row = i / cells.x;
    smooth[i] = tent(grid + row * cells.x, i - row * cells.x, 1, cells.x);
}

/* The factor of the limit at a place. focus: centre, radius and falloff. */
static float limit_factor(const float2 place, const float4 focus, const float far_limit) {
    if (!(focus.w > 0.0f)) return 1.0f;
    const float2 away = place - xy(focus);
    const float distance = sqrt(away.x * away.x + away.y * away.y);
    const float t = clamp((distance - focus.z) / focus.w, 0.0f, 1.0f);
    return 1.0f + (far_limit - 1.0f) * (t * t * (3.0f - 2.0f * t));
}

/* The mean of a ramp over densities from `before` to `before + own`. The ramp falls from 1 at
 * allowed - soft to 0 at allowed + soft. The length that is drawn of all lines is the ramp's
 * integral: at most `allowed`, and exactly `allowed` if there are enough lines. */
static float mean_weight(const float before, const float own, const float allowed,
                         const float soft) {
    const float whole = clamp((allowed - soft) - before, 0.0f, own);
    const float from = fmax(before, allowed - soft);
    const float to = fmin(before + own, allowed + soft);
    if (!(to > from)) return whole / own;
    const float middle = (from + to) * 0.5f;
    return (whole + (to - from) * (((allowed + soft) - middle) / (2.0f * soft))) / own;
}

/* The limit of a cell, in the units of smoothed sums: length per cell. */
static float allowed_in(const int x, const int y, const float cell, const float limit,
                        const float4 focus, const float far_limit) {
    const float2 place = (float2((float)x, (float)y) + 0.5f) * cell;
    return limit * limit_factor(place, focus, far_limit) *
           (LA_DENSITY_UNITS_PER_PIXEL * LA_DENSITY_TENT * cell * cell);
}

/* The largest excess about a cell. Lines that are too many there are drawn in all of these cells.
 */
static float excess_about(__global const float* excess, const int2 cells, const int x,
                          const int y) {
    float most = 0.0f;
    for (int v = max(y - 2, 0); v <= min(y + 2, cells.y - 1); ++v)
        for (int u = max(x - 2, 0); u <= min(x + 2, cells.x - 1); ++u)
            most = fmax(most, excess[v * cells.x + u]);
    return most;
}

/* The tent along the columns, then the weights of all bins, those of more priority first. drawn:
 * the length that the weights leave in each cell. again 1: makes weights anew where the first ones
 * left too much, by `excess` of the limit. again 0: `excess` is not read. */
KERNEL(density_weights, DensityParameters) {
    const int2 cells = to_int2(args.cells);
    const float4 focus = to_float4(args.focus);
    const int cell = (int)get_global_id(0);
    const int plane = cells.x * cells.y;
    if (cell >= plane) return;
    const int y = cell / cells.x;
    const int x = cell - y * cells.x;
    const float too_much = args.again != 0 ? excess_about(excess, cells, x, y) : 0.0f;
    if (args.again != 0 && too_much == 0.0f) return;
    const float allowed =
        allowed_in(x, y, args.cell, args.density.limit, focus, args.far_limit) / (1.0f + too_much);
    const float soft = allowed * LA_DENSITY_SOFTNESS;
    float before = 0.0f, left = 0.0f;
    for (int bin = (int)LA_DENSITY_BINS - 1; bin >= 0; --bin) {
        const float own = fmax((float)tent(smooth + bin * plane + x, y, cells.x, cells.y), 1.0f);
        const float weight = mean_weight(before, own, allowed, soft);
        weights[bin * plane + cell] = weight;
        left += weight * (float)grid[bin * plane + cell];
        before += own;
    }
    drawn[cell] = left;
}

/* excess: the share of the limit by which the weights leave too much about each cell. At the edges
 * of a heap there are fewer lines, and more of them are kept than in its middle. */
KERNEL(density_excess, DensityParameters) {
    const int2 cells = to_int2(args.cells);
    const float4 focus = to_float4(args.focus);
    const int cell = (int)get_global_id(0);
    if (cell >= cells.x * cells.y) return;
    const int y = cell / cells.x;
    const int x = cell - y * cells.x;
    float left = 0.0f;
    for (int dy = -2; dy <= 2; ++dy) {
        __global const float* row = drawn + clamp(y + dy, 0, cells.y - 1) * cells.x;
        for (int dx = -2; dx <= 2; ++dx) {
            const float share = (float)((3 - abs(dx)) * (3 - abs(dy)));
            left += share * row[clamp(x + dx, 0, cells.x - 1)];
        }
    }
    const float allowed = allowed_in(x, y, args.cell, args.density.limit, focus, args.far_limit);
    excess[cell] = fmax(left / (allowed * LA_DENSITY_TOLERATED) - 1.0f, 0.0f);
}
