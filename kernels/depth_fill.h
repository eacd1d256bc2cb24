/* One triangle into a tile. Included once, by depth_triangle.h. */
#include "depth_tile.h"
#include "shared/float_pair.h"

/* Corners are rounded to this grid, as llvmpipe and most GPUs do: units per texel. */
#define GRID_BITS 8
#define GRID 256

/* A triangle is a sliver if its area on the grid is more than this many times the area between its
 * corners. */
#define SLIVER 4.0f
/* Window depth by which a triangle or a box counts as nearer when it is tested for being hidden,
 * since planes are rounded. */
#define PLANE_ROUNDING 1e-6f

/* The inside of three lines: a x + b y + c is at least 0 for each line, in texels counted from
 * where filling begins. */
typedef struct Edges {
    int a[3], b[3], c[3];
} Edges;

/* Window depth where filling begins, and its change from texel to texel. */
typedef struct DepthPlane {
    float z, x, y;
} DepthPlane;

/* Fills LANES texels, from the one at `at` on. Each gets the nearer of its depth and that of the
 * triangle, if it is inside the edges. */
INLINED void fill_lanes(const Tile* tile, const int at, const int number, const lanes_int outside,
                        const lanes_float z) {
    __local float* texels = tile->texels + at;
    const lanes_float before = LOAD_LANES(texels);
    const lanes_int none = 0;
    const lanes_mask shows = (outside >= none) & (z < before);
    STORE_LANES(SELECT(before, z, shows), texels);
#ifdef NUMBERED
    __local int* numbers = tile->numbers + at;
    const lanes_int own = number, shown = LOAD_INTS(numbers);
    STORE_LANES(SELECT(shown, own, shows), numbers);
#endif
}

/* Fills a triangle of at most `vectors` times LANES columns, from the texel at `at` on. */
INLINED void fill_narrow(const Tile* tile, const int at, const int number, const int rows,
                         const Edges* edges, const DepthPlane plane, const int vectors) {
    for (int v = 0; v < vectors; ++v) {
        const lanes_int column = LANE_INDEX + v * LANES;
        lanes_int e0 = column * edges->a[0] + edges->c[0];
        lanes_int e1 = column * edges->a[1] + edges->c[1];
        lanes_int e2 = column * edges->a[2] + edges->c[2];
        const lanes_float z = TO_FLOAT(column) * plane.x + plane.z;
        int row = at + v * LANES;
        for (int y = 0; y <= rows; ++y) {
            fill_lanes(tile, row, number, e0 | e1 | e2, z + (float)y * plane.y);
            e0 += edges->b[0];
            e1 += edges->b[1];
            e2 += edges->b[2];
            row += TILE_STRIDE;
        }
    }
}

/* Fills a wider triangle: `texels` begin a vector. Where each row begins and ends is found for
 * LANES rows at once, in floats and a little too wide; the edges decide. */
INLINED void fill_wide(const Tile* tile, const int at, const int number, const int columns,
                       const int rows, const Edges* edges, const DepthPlane plane) {
    const float none = 0.0f, far = 1e6f;
    float left_slope[3], left[3], right_slope[3], right[3];
    for (int k = 0; k < 3; ++k) {
        const int a = edges->a[k];
        const float slope = a != 0 ? -(float)edges->b[k] / (float)a : none;
        const float at = a != 0 ? -(float)edges->c[k] / (float)a : none;
        const float spare = 1.0f + 4e-7f * (fabs(at) + fabs(slope) * (float)rows);
        left_slope[k] = a > 0 ? slope : none;
        left[k] = a > 0 ? at - spare : -far;
        right_slope[k] = a < 0 ? slope : none;
        right[k] = a < 0 ? at + spare : far;
    }
    for (int first = 0; first <= rows; first += LANES) {
        int begins[LANES], ends[LANES];
        const lanes_float y = TO_FLOAT(LANE_INDEX + first), most = far;
        lanes_float begin = 0.0f, end = (float)columns;
        for (int k = 0; k < 3; ++k) {
            begin = fmax(begin, y * left_slope[k] + left[k]);
            end = fmin(end, y * right_slope[k] + right[k]);
        }
        STORE_LANES(FLOOR_TO_INT(fmin(begin, most)) & ~(LANES - 1), begins);
        STORE_LANES(FLOOR_TO_INT(fmax(end, -most)), ends);
        const int last = min(rows - first, LANES - 1);
        for (int i = 0; i <= last; ++i) {
            const int row = first + i, start = begins[i], stop = ends[i];
            if (start > stop) continue;
            const int to = at + row * TILE_STRIDE;
            const lanes_int column = LANE_INDEX + start;
            lanes_int e0 = column * edges->a[0] + (edges->c[0] + edges->b[0] * row);
            lanes_int e1 = column * edges->a[1] + (edges->c[1] + edges->b[1] * row);
            lanes_int e2 = column * edges->a[2] + (edges->c[2] + edges->b[2] * row);
            const int step0 = edges->a[0] * LANES, step1 = edges->a[1] * LANES;
            const int step2 = edges->a[2] * LANES;
            const float z = plane.z + plane.y * (float)row;
            lanes_float across = TO_FLOAT(column);
            for (int x = start; x <= stop; x += LANES) {
                fill_lanes(tile, to + x, number, e0 | e1 | e2, across * plane.x + z);
                e0 += step0;
                e1 += step1;
                e2 += step2;
                across += (float)LANES;
            }
        }
    }
}

/* Texels a side of the pieces in which large triangles are filled. Within a piece the value of an
 * edge fits an int. */
#define PIECE 64

/* Corners in the whole picture, on the grid. */
typedef struct GridTriangle {
    la_long x[3], y[3];
} GridTriangle;

/* Finds the edges that matter in the box from the texel `first` to `columns` and `rows` beyond it,
 * counted from that texel. Returns false if the triangle doesn't touch the box. */
static bool edges_in_box(const GridTriangle* t, const int2 first, const int columns, const int rows,
                         Edges* edges) {
    for (int k = 0; k < 3; ++k) {
        const int next = k == 2 ? 0 : k + 1;
        const la_long way_x = t->x[next] - t->x[k], way_y = t->y[next] - t->y[k];
        const bool is_own = way_y < 0 || (way_y == 0 && way_x < 0);
        const la_long above = way_x * ((la_long)first.y * GRID - t->y[k]) -
                              way_y * ((la_long)first.x * GRID - t->x[k]);
        const la_long c = (above - (is_own ? 0 : 1)) >> GRID_BITS;
        const la_long across = -way_y * (la_long)columns, up = way_x * (la_long)rows, none = 0;
        if (c + max(across, none) + max(up, none) < 0) return false;
        const bool all = c + min(across, none) + min(up, none) >= 0;
        edges->a[k] = all ? 0 : (int)-way_y;
        edges->b[k] = all ? 0 : (int)way_x;
        edges->c[k] = all ? 0 : (int)c;
    }
    return true;
}

/* (a1 - a0) (b2 - b0) - (a2 - a0) (b1 - b0). */
static float cross_of(const float* a, const float* b) {
    return pair_minor(pair_of_sum(a[1], -a[0]), pair_of_sum(a[2], -a[0]), pair_of_sum(b[1], -b[0]),
                      pair_of_sum(b[2], -b[0]))
        .high;
}

/* Fills a triangle of any size. Its corners are in texels of the whole picture and window depth. */
INLINED void fill_large(Tile* tile, const int number, const float3 a, const float3 b,
                        const float3 c) {
    const float3 given[3] = {a, b, c};
    const la_long low_x = (la_long)tile->low.x * GRID, low_y = (la_long)tile->low.y * GRID;
    la_long grid_x[3], grid_y[3];
    for (int k = 0; k < 3; ++k) {
        grid_x[k] = (la_long)convert_int_rte(given[k].x * (float)GRID) - low_x;
        grid_y[k] = (la_long)convert_int_rte(given[k].y * (float)GRID) - low_y;
    }
    const la_long doubled = (grid_x[1] - grid_x[0]) * (grid_y[2] - grid_y[0]) -
                            (grid_x[2] - grid_x[0]) * (grid_y[1] - grid_y[0]);
    if (doubled == 0) return;
    const bool turned = doubled < 0;
    GridTriangle t;
    float x[3], y[3], z[3];
    for (int k = 0; k < 3; ++k) {
        const int from = turned && k > 0 ? 3 - k : k;
        t.x[k] = grid_x[from];
        t.y[k] = grid_y[from];
        x[k] = given[from].x;
        y[k] = given[from].y;
        z[k] = given[from].z;
    }
    const la_long none = 0, up = GRID - 1;
    const la_long right = tile->size.x - 1, top = tile->size.y - 1;
    const int first_x = (int)max((min(t.x[0], min(t.x[1], t.x[2])) + up) >> GRID_BITS, none);
    const int first_y = (int)max((min(t.y[0], min(t.y[1], t.y[2])) + up) >> GRID_BITS, none);
    const int last_x = (int)min(max(t.x[0], max(t.x[1], t.x[2])) >> GRID_BITS, right);
    const int last_y = (int)min(max(t.y[0], max(t.y[1], t.y[2])) >> GRID_BITS, top);
    if (first_x > last_x || first_y > last_y) return;

    /* In pairs: for a long sliver, products of floats would cancel until only rounding is left. */
    float area = cross_of(x, y);
    const float area_there = (float)(turned ? -doubled : doubled) * (1.0f / (GRID * GRID));
    if (area * SLIVER < area_there) { /* as in set_up() */
        for (int k = 0; k < 3; ++k) {
            x[k] = (float)(t.x[k] + low_x) * (1.0f / GRID);
            y[k] = (float)(t.y[k] + low_y) * (1.0f / GRID);
        }
        area = area_there;
    }
    const float z_x = cross_of(z, y) / area, z_y = cross_of(x, z) / area;
    const float nearest = fmin(z[0], fmin(z[1], z[2])) - PLANE_ROUNDING;
    for (int piece_y = first_y & ~(PIECE - 1); piece_y <= last_y; piece_y += PIECE) {
        for (int piece_x = first_x & ~(PIECE - 1); piece_x <= last_x; piece_x += PIECE) {
            const int from_x = max(piece_x, first_x), to_x = min(piece_x + PIECE - 1, last_x);
            const int from_y = max(piece_y, first_y), to_y = min(piece_y + PIECE - 1, last_y);
            const int2 start = int2(from_x & ~(LANES - 1), from_y);
            const int columns = to_x - start.x, rows = to_y - from_y;
            const float at_start = z[0] + (z_x * ((float)(start.x + tile->low.x) - x[0]) +
                                           z_y * ((float)(start.y + tile->low.y) - y[0]));
            const float in_piece = at_start + fmin(z_x, 0.0f) * (float)columns +
                                   fmin(z_y, 0.0f) * (float)rows - PLANE_ROUNDING;
            if (!triangle_shows(tile, int4(from_x, from_y, to_x, to_y), fmax(nearest, in_piece)))
                continue;
            Edges edges;
            /* Lanes beyond the last column are filled too, so edges are right there as well. */
            if (!edges_in_box(&t, start, columns | (LANES - 1), rows, &edges)) continue;
            const DepthPlane plane = {at_start, z_x, z_y};
            fill_wide(tile, start.y * TILE_STRIDE + start.x, number, columns, rows, &edges, plane);
        }
    }
}

/* Corners of a triangle that is cut by six planes. */
#define MOST_CORNERS 10

static float above_plane(const float4 v, const int plane, const float guard) {
    switch (plane) {
    case 0:
        return v.z + v.w;
    case 1:
        return v.w - v.z;
    case 2:
        return guard * v.w - v.x;
    case 3:
        return guard * v.w + v.x;
    case 4:
        return guard * v.w - v.y;
    default:
        return guard * v.w + v.y;
    }
}

/* Cuts the triangle in corner[0] to [2] by near plane, far plane and guard band; returns how many
 * corners are left. */
static int clip_to_view(float4* corner, const float guard) {
    float4 kept[MOST_CORNERS];
    int count = 3;
    for (int plane = 0; plane < 6; ++plane) {
        int left = 0;
        for (int i = 0; i < count; ++i) {
            const float4 u = corner[i], v = corner[i + 1 == count ? 0 : i + 1];
            const float at_u = above_plane(u, plane, guard), at_v = above_plane(v, plane, guard);
            if (at_u >= 0.0f) kept[left++] = u;
            if ((at_u >= 0.0f) != (at_v >= 0.0f))
                kept[left++] = u + (v - u) * (at_u / (at_u - at_v));
        }
        if (left < 3) return 0;
        count = left;
        for (int i = 0; i < count; ++i) corner[i] = kept[i];
    }
    return count;
}
