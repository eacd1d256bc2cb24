/* Triangles into the depth buffer, each by itself: the form of a GPU (Tuning::depth_each). Included
 * once, by depth.cl.
 *
 * Atomic minima of depth and rank find what is nearest in a texel, if the device has atomics of 64
 * bits (LONG_ATOMICS). Otherwise a first pass finds the depth, and a second pass the lowest rank of
 * the triangles that have this depth. The form by tiles draws triangles in the order of their
 * ranks. A plane is followed from the same texel on as in that form, which depends on where tiles
 * of DEPTH_TILE texels begin, and on LANES. So all forms give the same bits. Both are numbers of
 * DepthParameters here, so that C++ can be compared with a device that has others.
 *
 * A triangle whose box has few texels is filled by one work-item. The others are listed, and
 * LA_DEPTH_SHARE work-items share each. */

/* Texels of the box around a triangle that one work-item fills. */
#define FEW_TEXELS 64
/* The square of this is the number of work-items that fill one piece of a triangle together. */
#define SHARE_SIDE 8
/* Marks entries of the list of large triangles that ints don't hold, or planes of the view cut. */
#define SET_UP_IN_PAIRS 0x80000000u
/* Marks large triangles that all LA_DEPTH_SHARE work-items share. Only the first SHARE_SIDE squared
 * of them share any other large triangle. */
#define WIDE 0x40000000u
/* The most tiles that a triangle may touch and not be wide. */
#define FEW_TILES 8

/* Depths as whole numbers of the same order. */
static uint order_of(const float depth) {
    const uint bits = as_uint(depth + 0.0f); /* 0 has one sign */
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

static float depth_of(const uint order) {
    return as_float((order & 0x80000000u) != 0 ? order & 0x7FFFFFFFu : ~order);
}

/* Ranks of triangles, in the order in which the form by tiles draws them: by cluster, then by
 * `lanes` triangles of the cluster. Of these, triangles that are set up in ints come first, then
 * large ones, then those that are cut. */
#define SET_UP_IN_INTS 0u
#define LARGE 1u
#define CUT 2u
static uint rank_of(const uint position, const uint triangle, const uint way, const uint lanes) {
    const uint lane = triangle & (lanes - 1u), batch = triangle - lane;
    return position << LA_RANK_BITS | (batch * 4u + way * lanes + lane);
}

static uint triangle_of(const uint rank, const uint lanes) {
    const uint own = rank & ((1u << LA_RANK_BITS) - 1u);
    return own / (4u * lanes) * lanes + (own & (lanes - 1u));
}

#if LONG_ATOMICS
#ifdef __OPENCL_VERSION__
#pragma OPENCL EXTENSION cl_khr_int64_extended_atomics : enable
#endif
#define PUT_BOTH(own, order, rank)                                                                 \
    atom_min((__global ulong*)(own), (ulong)(order) << 32 | (ulong)(rank))
#else
#define PUT_BOTH(own, order, rank) (void)0 /* the host does not ask for it */
#endif

/* The target of a triangle. Texels are counted in the whole picture. */
typedef struct Target {
    int2 origin;     /* the first of the tables */
    int2 base;       /* the first tile's first */
    int2 last;       /* the last that is drawn */
    int width;       /* of the tables */
    int side, lanes; /* as in DepthParameters */
    uint finds;      /* LA_FINDS_* */
    uint rank;
    __global DepthTexel* texels;
} Target;

/* The first texel of `depth` beyond the tiles. */
static int2 end_of_tiles(const DepthParameters* args) {
    const int2 low = to_int2(args->covered), tiles = to_int2(args->tiles);
    const int2 size = to_int2(args->depth_size);
    return int2(min(low.x + tiles.x * args->side, size.x),
                min(low.y + tiles.y * args->side, size.y));
}

INLINED void make_target(const DepthParameters* args, __global DepthTexel* texels, Target* to) {
    to->origin = to_int2(args->origin);
    to->base = to->origin + to_int2(args->covered);
    const int2 end = end_of_tiles(args);
    to->last = int2(to->origin.x + end.x - 1, to->origin.y + end.y - 1);
    to->width = args->depth_size.v[0];
    to->side = args->side;
    to->lanes = args->lanes;
    to->finds = args->finds;
    to->rank = 0;
    to->texels = texels;
}

INLINED void put(const Target* to, const int x, const int y, const float depth) {
    if (!(depth < 1.0f)) return; /* nor what is no number */
    const size_t at = (size_t)(y - to->origin.y) * (size_t)to->width + (size_t)(x - to->origin.x);
    __global DepthTexel* own = to->texels + at;
    const uint order = order_of(depth);
    if (to->finds == LA_FINDS_DEPTHS)
        atomic_min(&own->order, order);
    else if (to->finds == LA_FINDS_BOTH)
        PUT_BOTH(own, order, to->rank);
    else if (own->order == order)
        atomic_min(&own->rank, to->rank);
}

/* A vertex as place_vertices() places it. */
static float3 place_vertex(const View* view, const float3 v) {
    const Matrix m = view->m;
    const float clip_x = (v.x * m.x.x + v.y * m.y.x) + (v.z * m.z.x + m.w.x);
    const float clip_y = (v.x * m.x.y + v.y * m.y.y) + (v.z * m.z.y + m.w.y);
    const float clip_z = (v.x * m.x.z + v.y * m.y.z) + (v.z * m.z.z + m.w.z);
    const float w = (v.x * m.x.w + v.y * m.y.w) + (v.z * m.z.w + m.w.w);
    const float widest = w * view->guard;
    const bool inside = fabs(clip_z) <= w && fabs(clip_x) <= widest && fabs(clip_y) <= widest;
    const float inverse = 1.0f / w;
    return float3(inside ? (clip_x * inverse) * view->half_size.x + view->shift.x : CLIPPED,
                  (clip_y * inverse) * view->half_size.y + view->shift.y,
                  (clip_z * inverse) * 0.5f + 0.5f);
}

/* A triangle of a meshlet. */
typedef struct OneTriangle {
    float3 a, b, c; /* its corners' places; x is CLIPPED as in Places */
    uint i, j, k;   /* its vertices */
} OneTriangle;

static OneTriangle one_triangle(const View* view, const Meshlet meshlet, const uint t,
                                __global const uint* vertex_list, __global const uchar* corners,
                                __global const float* vertices) {
    __global const uint* list = vertex_list + meshlet.vertices;
    __global const uchar* own = corners + meshlet.corners + t;
    const uint row =
        (meshlet.triangle_count + LA_MESHLET_PADDING - 1u) & ~(LA_MESHLET_PADDING - 1u);
    OneTriangle one;
    one.i = list[own[0]];
    one.j = list[own[row]];
    one.k = list[own[2u * row]];
    one.a = place_vertex(view, vload3(one.i, vertices));
    one.b = place_vertex(view, vload3(one.j, vertices));
    one.c = place_vertex(view, vload3(one.k, vertices));
    return one;
}

static bool is_cut(const OneTriangle* one) {
    return fmax(one->a.x, fmax(one->b.x, one->c.x)) >= 0.5f * CLIPPED;
}

/* Corners on the grid, turned so that the area is positive; and as they were given. */
typedef struct Turned {
    int x[3], y[3];
    float3 a, b, c;
} Turned;

static int on_grid(const float place) {
    return convert_int_rte(place * (float)GRID);
}

static Turned turn(const float3 a, const float3 b, const float3 c, const bool turned) {
    Turned t;
    t.a = a;
    t.b = b;
    t.c = c;
    if (turned) {
        t.b = c;
        t.c = b;
    }
    t.x[0] = on_grid(t.a.x);
    t.y[0] = on_grid(t.a.y);
    t.x[1] = on_grid(t.b.x);
    t.y[1] = on_grid(t.b.y);
    t.x[2] = on_grid(t.c.x);
    t.y[2] = on_grid(t.c.y);
    return t;
}

/* The texels of the picture whose middles lie in the box around the corners: xy to zw, inclusive.
 * large: whether the triangle is too large to be set up in ints. */
static int4 texels_of(const float3 a, const float3 b, const float3 c, bool* large) {
    const int x0 = on_grid(a.x), y0 = on_grid(a.y), x1 = on_grid(b.x), y1 = on_grid(b.y);
    const int x2 = on_grid(c.x), y2 = on_grid(c.y);
    const int least_x = min(x0, min(x1, x2)), most_x = max(x0, max(x1, x2));
    const int least_y = min(y0, min(y1, y2)), most_y = max(y0, max(y1, y2));
    *large = most_x - least_x > MOST_UNITS || most_y - least_y > MOST_UNITS;
    return int4((least_x + (GRID - 1)) >> GRID_BITS, (least_y + (GRID - 1)) >> GRID_BITS,
                most_x >> GRID_BITS, most_y >> GRID_BITS);
}

static int4 within(const Target* to, const int4 box) {
    return int4(max(box.x, to->base.x), max(box.y, to->base.y), min(box.z, to->last.x),
                min(box.w, to->last.y));
}

static bool is_empty(const int4 box) {
    return box.x > box.z || box.y > box.w;
}

/* The depth of a plane at a corner's place, and its change from texel to texel. */
typedef struct CornerPlane {
    float x, y, z, z_x, z_y;
} CornerPlane;

/* As set_up() makes it. doubled: twice the area on the grid, not 0. */
static CornerPlane plane_in_ints(const Turned* t, const int doubled) {
    const float area_there = (float)doubled * (1.0f / (GRID * GRID)), unit = 1.0f / GRID;
    float ax = t->a.x, ay = t->a.y, bx = t->b.x, by = t->b.y, cx = t->c.x, cy = t->c.y;
    float area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area * SLIVER < area_there) {
        ax = (float)t->x[0] * unit;
        ay = (float)t->y[0] * unit;
        bx = (float)t->x[1] * unit;
        by = (float)t->y[1] * unit;
        cx = (float)t->x[2] * unit;
        cy = (float)t->y[2] * unit;
        area = area_there;
    }
    const float inverse = 1.0f / area;
    const float to_b = t->b.z - t->a.z, to_c = t->c.z - t->a.z;
    const CornerPlane plane = {ax, ay, t->a.z, (to_b * (cy - ay) - to_c * (by - ay)) * inverse,
                               ((bx - ax) * to_c - (cx - ax) * to_b) * inverse};
    return plane;
}

/* As fill_large() makes it. */
static CornerPlane plane_in_pairs(const Turned* t, const la_long doubled) {
    float x[3] = {t->a.x, t->b.x, t->c.x}, y[3] = {t->a.y, t->b.y, t->c.y};
    const float z[3] = {t->a.z, t->b.z, t->c.z};
    float area = cross_of(x, y);
    const float area_there = (float)doubled * (1.0f / (GRID * GRID));
    if (area * SLIVER < area_there) {
        for (int k = 0; k < 3; ++k) {
            x[k] = (float)t->x[k] * (1.0f / GRID);
            y[k] = (float)t->y[k] * (1.0f / GRID);
        }
        area = area_there;
    }
    const CornerPlane plane = {x[0], y[0], z[0], cross_of(z, y) / area, cross_of(x, z) / area};
    return plane;
}

/* A plane from the texel on from which the form by tiles follows it in a tile, or in a piece of a
 * tile. */
typedef struct Followed {
    DepthPlane plane;
    int first; /* column of that texel */
    bool by_columns;
} Followed;

/* low: first texel of the tile; from, to: the columns that are filled; row: the first row. */
static Followed follow(const CornerPlane plane, const int2 low, const int from, const int to,
                       const int row, const bool in_ints, const int lanes) {
    Followed f;
    f.by_columns = in_ints && to - from < 2 * lanes;
    f.first = f.by_columns ? from : ((from - low.x) & ~(lanes - 1)) + low.x;
    f.plane.x = plane.z_x;
    f.plane.y = plane.z_y;
    f.plane.z =
        plane.z + (plane.z_x * ((float)f.first - plane.x) + plane.z_y * ((float)row - plane.y));
    return f;
}

static float depth_there(const Followed* f, const int column, const int row) {
    const float x = (float)column, y = (float)row;
    return f->by_columns ? (x * f->plane.x + f->plane.z) + y * f->plane.y
                         : x * f->plane.x + (f->plane.z + f->plane.y * y);
}

/* The value of edge k at the texel (x, y), as set_edge() computes it. */
static int edge_at(const Turned* t, const int k, const int x, const int y) {
    const int next = k == 2 ? 0 : k + 1;
    const int way_x = t->x[next] - t->x[k], way_y = t->y[next] - t->y[k];
    const bool is_own = way_y < 0 || (way_y == 0 && way_x < 0);
    const int above = way_x * (y * GRID - t->y[k]) - way_y * (x * GRID - t->x[k]);
    return (above - (is_own ? 0 : 1)) >> GRID_BITS;
}

/* Fills a triangle that is set up in ints, in a part of a tile from `low` on. */
INLINED void fill_part(const Target* to, const Turned* t, const CornerPlane plane, const int2 low,
                       const int4 part) {
    const Followed f = follow(plane, low, part.x, part.z, part.y, true, to->lanes);
    int e0 = edge_at(t, 0, part.x, part.y), e1 = edge_at(t, 1, part.x, part.y);
    int e2 = edge_at(t, 2, part.x, part.y);
    for (int y = part.y; y <= part.w; ++y) {
        int row0 = e0, row1 = e1, row2 = e2;
        for (int x = part.x; x <= part.z; ++x) {
            if ((row0 | row1 | row2) >= 0) put(to, x, y, depth_there(&f, x - f.first, y - part.y));
            row0 -= t->y[1] - t->y[0];
            row1 -= t->y[2] - t->y[1];
            row2 -= t->y[0] - t->y[2];
        }
        e0 += t->x[1] - t->x[0];
        e1 += t->x[2] - t->x[1];
        e2 += t->x[0] - t->x[2];
    }
}

/* The first texel of the tile that a texel is in. */
static int tile_low(const int texel, const int base, const int side) {
    return base + (texel - base) / side * side;
}

/* Fills a triangle whose box is `box`, set up in ints. */
INLINED void fill_small(const Target* to, const float3 a, const float3 b, const float3 c,
                        const int4 box) {
    const int x0 = on_grid(a.x), y0 = on_grid(a.y);
    const int doubled =
        (on_grid(b.x) - x0) * (on_grid(c.y) - y0) - (on_grid(c.x) - x0) * (on_grid(b.y) - y0);
    if (doubled == 0) return;
    const Turned t = turn(a, b, c, doubled < 0);
    const CornerPlane plane = plane_in_ints(&t, doubled < 0 ? -doubled : doubled);
    for (int y = tile_low(box.y, to->base.y, to->side); y <= box.w; y += to->side) {
        for (int x = tile_low(box.x, to->base.x, to->side); x <= box.z; x += to->side) {
            fill_part(to, &t, plane, int2(x, y),
                      int4(max(x, box.x), max(y, box.y), min(x + to->side - 1, box.z),
                           min(y + to->side - 1, box.w)));
        }
    }
}

/* Whether a work-item has a share of a triangle. */
static bool has_share(const uint share, const bool wide) {
    return wide || share < SHARE_SIDE * SHARE_SIDE;
}

/* Whether work-item `share` fills a part of piece number `count`. */
static bool takes(const uint share, const bool wide, const uint count) {
    const uint squared = SHARE_SIDE * SHARE_SIDE;
    return !wide || count % (LA_DEPTH_SHARE / squared) == share / squared;
}

static bool is_wide(const int4 box, const int side) {
    return ((box.z - box.x) / side + 1) * ((box.w - box.y) / side + 1) > FEW_TILES;
}

/* Fills the part of work-item `share` between two texels. */
INLINED void fill_piece(const Target* to, const Edges* edges, const Followed f, const int4 piece,
                        const uint share) {
    const int columns = piece.z - f.first, rows = piece.w - piece.y;
    for (int y = (int)(share / SHARE_SIDE) % SHARE_SIDE; y <= rows; y += SHARE_SIDE) {
        for (int x = piece.x - f.first + (int)(share % SHARE_SIDE); x <= columns; x += SHARE_SIDE) {
            const int e0 = edges->a[0] * x + (edges->c[0] + edges->b[0] * y);
            const int e1 = edges->a[1] * x + (edges->c[1] + edges->b[1] * y);
            const int e2 = edges->a[2] * x + (edges->c[2] + edges->b[2] * y);
            if ((e0 | e1 | e2) >= 0) put(to, f.first + x, piece.y + y, depth_there(&f, x, y));
        }
    }
}

/* Finds the edges of a triangle that is set up in ints, from the texel at `first` on. Returns false
 * if it does not touch the box from there to `columns` and `rows` beyond. */
static bool int_edges_in_box(const Turned* t, const int2 first, const int columns, const int rows,
                             Edges* edges) {
    for (int k = 0; k < 3; ++k) {
        const int next = k == 2 ? 0 : k + 1;
        edges->a[k] = t->y[k] - t->y[next];
        edges->b[k] = t->x[next] - t->x[k];
        edges->c[k] = edge_at(t, k, first.x, first.y);
        if (edges->c[k] + max(edges->a[k] * columns, 0) + max(edges->b[k] * rows, 0) < 0)
            return false;
    }
    return true;
}

/* Fills the part of work-item `share` of a triangle that ints hold and whose box is `box`. */
INLINED void fill_shared(const Target* to, const float3 a, const float3 b, const float3 c,
                         const int4 box, const bool wide, const uint share) {
    const int x0 = on_grid(a.x), y0 = on_grid(a.y);
    const int doubled =
        (on_grid(b.x) - x0) * (on_grid(c.y) - y0) - (on_grid(c.x) - x0) * (on_grid(b.y) - y0);
    if (doubled == 0) return;
    const Turned t = turn(a, b, c, doubled < 0);
    const CornerPlane plane = plane_in_ints(&t, doubled < 0 ? -doubled : doubled);
    uint count = 0;
    for (int y = tile_low(box.y, to->base.y, to->side); y <= box.w; y += to->side) {
        for (int x = tile_low(box.x, to->base.x, to->side); x <= box.z; x += to->side) {
            if (!takes(share, wide, count++)) continue;
            const int4 piece = int4(max(x, box.x), max(y, box.y), min(x + to->side - 1, box.z),
                                    min(y + to->side - 1, box.w));
            const Followed f =
                follow(plane, int2(x, y), piece.x, piece.z, piece.y, true, to->lanes);
            Edges edges;
            if (int_edges_in_box(&t, int2(f.first, piece.y), piece.z - f.first, piece.w - piece.y,
                                 &edges))
                fill_piece(to, &edges, f, piece, share);
        }
    }
}

/* The same of a triangle of any size. */
INLINED void fill_in_pairs(const Target* to, const float3 a, const float3 b, const float3 c,
                           const uint share) {
    const la_long x0 = on_grid(a.x), y0 = on_grid(a.y);
    const la_long doubled = ((la_long)on_grid(b.x) - x0) * ((la_long)on_grid(c.y) - y0) -
                            ((la_long)on_grid(c.x) - x0) * ((la_long)on_grid(b.y) - y0);
    if (doubled == 0) return;
    bool large;
    const int4 box = within(to, texels_of(a, b, c, &large));
    if (is_empty(box)) return;
    const Turned turned = turn(a, b, c, doubled < 0);
    const CornerPlane plane = plane_in_pairs(&turned, doubled < 0 ? -doubled : doubled);
    GridTriangle t;
    for (int k = 0; k < 3; ++k) {
        t.x[k] = turned.x[k];
        t.y[k] = turned.y[k];
    }
    const int side = min(PIECE, to->side); /* of the pieces of a tile */
    uint count = 0;
    for (int y = tile_low(box.y, to->base.y, to->side); y <= box.w; y += to->side) {
        for (int x = tile_low(box.x, to->base.x, to->side); x <= box.z; x += to->side) {
            const int right = min(x + to->side - 1, box.z);
            const int above = min(y + to->side - 1, box.w);
            for (int py = y; py <= above; py += side) {
                for (int px = x; px <= right; px += side) {
                    const int4 piece = int4(max(px, box.x), max(py, box.y),
                                            min(px + side - 1, right), min(py + side - 1, above));
                    if (is_empty(piece) || !takes(share, true, count++)) continue;
                    const Followed f =
                        follow(plane, int2(x, y), piece.x, piece.z, piece.y, false, to->lanes);
                    Edges edges;
                    if (edges_in_box(&t, int2(f.first, piece.y), piece.z - f.first,
                                     piece.w - piece.y, &edges))
                        fill_piece(to, &edges, f, piece, share);
                }
            }
        }
    }
}

/* Fills the part of work-item `share` of a triangle that planes of the view cut. */
INLINED void fill_cut(const Target* to, const View* view, const float3 a, const float3 b,
                      const float3 c, const uint share) {
    const Matrix m = view->m;
    float4 corner[MOST_CORNERS];
    corner[0] = (m.x * a.x + m.y * a.y) + (m.z * a.z + m.w);
    corner[1] = (m.x * b.x + m.y * b.y) + (m.z * b.z + m.w);
    corner[2] = (m.x * c.x + m.y * c.y) + (m.z * c.z + m.w);
    const int count = clip_to_view(corner, view->guard);
    for (int i = 2; i < count; ++i)
        fill_in_pairs(to, on_screen(view, corner[0]), on_screen(view, corner[i - 1]),
                      on_screen(view, corner[i]), share);
}
