/* Triangles into a tile: set up LANES at a time, then filled one after the other. Included once, by
 * depth.cl. */
#include "depth_fill.h"

/* Longest side of a triangle that is set up in ints, in units of the grid: a product of two is
 * below 2^30. */
#define MOST_UNITS 26000
/* The x of a corner that must be clipped. */
#define CLIPPED 1e30f

typedef struct View {
    Matrix m;
    float2 half_size; /* of the whole picture, texels */
    float2 shift;     /* places count from the middle of the first texel */
    float guard;
} View;

static View make_view(const DepthParameters* args) {
    View view;
    view.m = to_matrix(args->clip_from_world);
    view.half_size = convert_float2(to_int2(args->whole_size)) * 0.5f;
    view.shift = view.half_size - 0.5f;
    view.guard = args->guard;
    return view;
}

/* The vertices of a meshlet on the screen. If x is CLIPPED, the place means nothing. */
typedef struct Places {
    float x[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
    float y[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
    float z[LA_MESHLET_VERTICES + LA_MESHLET_PADDING];
} Places;

static void place_vertices(const View* view, __global const uint* list, const uint count,
                           __global const float* vertices, Places* places) {
    const Matrix m = view->m;
    for (uint i = 0; i < count; i += LANES) {
        const lanes_int at = LOAD_INTS(list + i) * 3;
        const lanes_float x = GATHER_LANES(vertices, at);
        const lanes_float y = GATHER_LANES(vertices + 1, at);
        const lanes_float z = GATHER_LANES(vertices + 2, at);
        const lanes_float clip_x = (x * m.x.x + y * m.y.x) + (z * m.z.x + m.w.x);
        const lanes_float clip_y = (x * m.x.y + y * m.y.y) + (z * m.z.y + m.w.y);
        const lanes_float clip_z = (x * m.x.z + y * m.y.z) + (z * m.z.z + m.w.z);
        const lanes_float w = (x * m.x.w + y * m.y.w) + (z * m.z.w + m.w.w);
        const lanes_float widest = w * view->guard, clipped = CLIPPED, one = 1.0f;
        const lanes_mask inside =
            (fabs(clip_z) <= w) & (fabs(clip_x) <= widest) & (fabs(clip_y) <= widest);
        const lanes_float inverse = one / w;
        const lanes_float place_x = (clip_x * inverse) * view->half_size.x + view->shift.x;
        STORE_LANES(SELECT(clipped, place_x, inside), places->x + i);
        STORE_LANES((clip_y * inverse) * view->half_size.y + view->shift.y, places->y + i);
        STORE_LANES((clip_z * inverse) * 0.5f + 0.5f, places->z + i);
    }
}

/* LANES triangles ready to be filled, in texels of the tile. */
typedef struct TriangleLanes {
    int a[3][LANES], b[3][LANES], c[3][LANES]; /* as in Edges */
    float z[LANES], z_x[LANES], z_y[LANES];    /* as in DepthPlane */
    float nearest[LANES];
    int x[LANES], y[LANES]; /* where filling begins */
    int columns[LANES], rows[LANES];
    uint to_fill, large, clipped; /* a bit per triangle: its way to be filled */
} TriangleLanes;

/* Edge k from (ax, ay) to (bx, by), from the texel at (x, y) on, all in units of the grid. */
static void set_edge(TriangleLanes* lanes, const int k, const lanes_int ax, const lanes_int ay,
                     const lanes_int bx, const lanes_int by, const lanes_int x, const lanes_int y) {
    const lanes_int way_x = bx - ax, way_y = by - ay, none = 0, one = 1;
    const lanes_mask is_own = (way_y < none) | ((way_y == none) & (way_x < none));
    const lanes_int above = way_x * (y - ay) - way_y * (x - ax);
    STORE_LANES(-way_y, lanes->a[k]);
    STORE_LANES(way_x, lanes->b[k]);
    STORE_LANES((above - SELECT(one, none, is_own)) >> GRID_BITS, lanes->c[k]);
}

/* x, y, z: of the three corners; in_use: how many triangles there are. */
INLINED void set_up(const Tile* tile, const lanes_float* x, const lanes_float* y,
                    const lanes_float* z, const int in_use, TriangleLanes* lanes) {
    const lanes_float grid = (float)GRID;
    const lanes_int low_x = tile->low.x * GRID, low_y = tile->low.y * GRID;
    const lanes_int none = 0, most = MOST_UNITS, up = GRID - 1;
    const lanes_int right = tile->size.x - 1, top = tile->size.y - 1;
    const lanes_mask clipped = fmax(x[0], fmax(x[1], x[2])) >= 0.5f * CLIPPED;
    const lanes_int x0 = ROUND_TO_INT(x[0] * grid) - low_x, y0 = ROUND_TO_INT(y[0] * grid) - low_y;
    const lanes_int x1 = ROUND_TO_INT(x[1] * grid) - low_x, y1 = ROUND_TO_INT(y[1] * grid) - low_y;
    const lanes_int x2 = ROUND_TO_INT(x[2] * grid) - low_x, y2 = ROUND_TO_INT(y[2] * grid) - low_y;
    const lanes_int least_x = min(x0, min(x1, x2)), most_x = max(x0, max(x1, x2));
    const lanes_int least_y = min(y0, min(y1, y2)), most_y = max(y0, max(y1, y2));
    const lanes_int first_x = max((least_x + up) >> GRID_BITS, none);
    const lanes_int first_y = max((least_y + up) >> GRID_BITS, none);
    const lanes_int last_x = min(most_x >> GRID_BITS, right);
    const lanes_int last_y = min(most_y >> GRID_BITS, top);
    const lanes_mask used = LANE_INDEX < in_use;
    const lanes_mask touches = used & (first_x <= last_x) & (first_y <= last_y) & !clipped;
    const lanes_mask large = (most_x - least_x > most) | (most_y - least_y > most);
    const lanes_int doubled = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
    lanes->clipped = LANE_BITS(used & clipped);
    lanes->large = LANE_BITS(touches & large);
    lanes->to_fill = LANE_BITS(touches & !large & (doubled != none));
    if (lanes->to_fill == 0) return;

    /* Both sides of a face count: triangles that turn the other way are reversed. */
    const lanes_mask turned = doubled < none;
    const lanes_int px = SELECT(x1, x2, turned), py = SELECT(y1, y2, turned);
    const lanes_int qx = SELECT(x2, x1, turned), qy = SELECT(y2, y1, turned);
    const lanes_int area = SELECT(doubled, -doubled, turned);
    const lanes_float pz = SELECT(z[1], z[2], turned), qz = SELECT(z[2], z[1], turned);
    const lanes_int columns = last_x - first_x, narrow = 2 * LANES;
    const lanes_int start = SELECT(first_x & ~(LANES - 1), first_x, columns < narrow);
    const lanes_int grid_x = start << GRID_BITS, grid_y = first_y << GRID_BITS;
    set_edge(lanes, 0, x0, y0, px, py, grid_x, grid_y);
    set_edge(lanes, 1, px, py, qx, qy, grid_x, grid_y);
    set_edge(lanes, 2, qx, qy, x0, y0, grid_x, grid_y);

    /* The plane goes through the exact corners, not through those on the grid: otherwise flat faces
     * would get steps. A sliver, whose exact area is hardly above 0, takes the area on the grid. */
    lanes_float ax = x[0], ay = y[0];
    lanes_float bx = SELECT(x[1], x[2], turned), by = SELECT(y[1], y[2], turned);
    lanes_float cx = SELECT(x[2], x[1], turned), cy = SELECT(y[2], y[1], turned);
    lanes_float area_here = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    const lanes_float area_there = TO_FLOAT(area) * (1.0f / (GRID * GRID));
    const lanes_mask sliver = area_here * SLIVER < area_there;
    if ((LANE_BITS(sliver) & lanes->to_fill) != 0) {
        const lanes_float unit = 1.0f / GRID;
        ax = SELECT(ax, TO_FLOAT(x0 + low_x) * unit, sliver);
        ay = SELECT(ay, TO_FLOAT(y0 + low_y) * unit, sliver);
        bx = SELECT(bx, TO_FLOAT(px + low_x) * unit, sliver);
        by = SELECT(by, TO_FLOAT(py + low_y) * unit, sliver);
        cx = SELECT(cx, TO_FLOAT(qx + low_x) * unit, sliver);
        cy = SELECT(cy, TO_FLOAT(qy + low_y) * unit, sliver);
        area_here = SELECT(area_here, area_there, sliver);
    }
    const lanes_float one = 1.0f;
    const lanes_float inverse = one / area_here;
    const lanes_float to_p = pz - z[0], to_q = qz - z[0];
    const lanes_float z_x = (to_p * (cy - ay) - to_q * (by - ay)) * inverse;
    const lanes_float z_y = ((bx - ax) * to_q - (cx - ax) * to_p) * inverse;
    STORE_LANES(z[0] + (z_x * (TO_FLOAT(start + tile->low.x) - ax) +
                        z_y * (TO_FLOAT(first_y + tile->low.y) - ay)),
                lanes->z);
    STORE_LANES(z_x, lanes->z_x);
    STORE_LANES(z_y, lanes->z_y);
    STORE_LANES(fmin(z[0], fmin(z[1], z[2])) - PLANE_ROUNDING, lanes->nearest);
    STORE_LANES(start, lanes->x);
    STORE_LANES(first_y, lanes->y);
    STORE_LANES(last_x - start, lanes->columns);
    STORE_LANES(last_y - first_y, lanes->rows);
}

INLINED void fill(Tile* tile, const int number, const TriangleLanes* lanes, const uint i) {
    const int x = lanes->x[i], y = lanes->y[i];
    const int columns = lanes->columns[i], rows = lanes->rows[i];
    if (!triangle_shows(tile, int4(x, y, x + columns, y + rows), lanes->nearest[i])) return;
    Edges edges;
    for (int k = 0; k < 3; ++k) {
        edges.a[k] = lanes->a[k][i];
        edges.b[k] = lanes->b[k][i];
        edges.c[k] = lanes->c[k][i];
    }
    const DepthPlane plane = {lanes->z[i], lanes->z_x[i], lanes->z_y[i]};
    const int at = y * TILE_STRIDE + x;
    if (columns < LANES)
        fill_narrow(tile, at, number, rows, &edges, plane, 1);
    else if (columns < 2 * LANES)
        fill_narrow(tile, at, number, rows, &edges, plane, 2);
    else
        fill_wide(tile, at, number, columns, rows, &edges, plane);
}

/* The place on the screen of a corner in clip space that is in front of the eye. */
static float3 on_screen(const View* view, const float4 corner) {
    const float3 n = xyz(corner) / corner.w;
    return float3(n.x * view->half_size.x + view->shift.x, n.y * view->half_size.y + view->shift.y,
                  n.z * 0.5f + 0.5f);
}

INLINED void draw_clipped(const View* view, Tile* tile, const int number, const float3 a,
                          const float3 b, const float3 c) {
    const Matrix m = view->m;
    float4 corner[MOST_CORNERS];
    corner[0] = (m.x * a.x + m.y * a.y) + (m.z * a.z + m.w);
    corner[1] = (m.x * b.x + m.y * b.y) + (m.z * b.z + m.w);
    corner[2] = (m.x * c.x + m.y * c.y) + (m.z * c.z + m.w);
    const int count = clip_to_view(corner, view->guard);
    float3 place[MOST_CORNERS];
    for (int i = 0; i < count; ++i) place[i] = on_screen(view, corner[i]);
    for (int i = 2; i < count; ++i) fill_large(tile, number, place[0], place[i - 1], place[i]);
}

/* number: of its first triangle. */
INLINED void draw_meshlet(const View* view, Tile* tile, const uint number, const Meshlet meshlet,
                          __global const uint* vertex_list, __global const uchar* corners,
                          __global const float* vertices) {
    Places places;
    __global const uint* list = vertex_list + meshlet.vertices;
    place_vertices(view, list, meshlet.vertex_count, vertices, &places);
    const uint row =
        (meshlet.triangle_count + LA_MESHLET_PADDING - 1u) & ~(LA_MESHLET_PADDING - 1u);
    for (uint first = 0; first < meshlet.triangle_count; first += LANES) {
        __global const uchar* own = corners + meshlet.corners + first;
        lanes_float x[3], y[3], z[3];
        for (uint k = 0; k < 3; ++k) {
            const lanes_int at = LOAD_BYTES(own + k * row);
            x[k] = GATHER_LANES(places.x, at);
            y[k] = GATHER_LANES(places.y, at);
            z[k] = GATHER_LANES(places.z, at);
        }
        TriangleLanes lanes;
        set_up(tile, x, y, z, (int)(meshlet.triangle_count - first), &lanes);
        for (uint bits = lanes.to_fill; bits != 0; bits &= bits - 1u)
            fill(tile, (int)(number + first + lowest_bit(bits)), &lanes, lowest_bit(bits));
        for (uint bits = lanes.large; bits != 0; bits &= bits - 1u) {
            __global const uchar* at = own + lowest_bit(bits);
            const uint i = at[0], j = at[row], k = at[2u * row];
            fill_large(tile, (int)(number + first + lowest_bit(bits)),
                       float3(places.x[i], places.y[i], places.z[i]),
                       float3(places.x[j], places.y[j], places.z[j]),
                       float3(places.x[k], places.y[k], places.z[k]));
        }
        for (uint bits = lanes.clipped; bits != 0; bits &= bits - 1u) {
            __global const uchar* at = own + lowest_bit(bits);
            draw_clipped(view, tile, (int)(number + first + lowest_bit(bits)),
                         vload3(list[at[0]], vertices), vload3(list[at[row]], vertices),
                         vload3(list[at[2u * row]], vertices));
        }
    }
}
