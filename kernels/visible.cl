/* visible: the visible parts of every segment, cut by the faces before it (tile_lists.cl), with
 * continuous ends.
 *
 * One work-item per segment, which goes from tile to tile. There are two steps. The first counts
 * the visible parts of each segment and keeps the first two of them. The second, after a scan of
 * the counts, writes all parts. The few segments with more than two parts are cut again.
 *
 * With Tuning::face_lists there is one work-item per piece instead, the part of a segment within a
 * tile, because a GPU would wait for the longest segment. visible_pieces counts pieces, visible_cut
 * counts their visible parts, visible_parts writes these parts, and visible_join and visible_spans
 * join those of a segment.
 *
 * FACE_LANES: how many faces are tested at once, 1 on GPUs. */

#define LANES FACE_LANES
#include "shared/exact.h"
#include "shared/float_pair.h"
#include "shared/lanes.h"
#include "visible_parts.h"

/* A piece whose ends are both nearer than this to a side's line, in pixels, is compared with it in
 * space: rounded places on the screen cannot tell which side of it the piece is on. */
#define CLOSE_TO_SIDE 0.01f

/* A contour is tested against its own surface from so many times its lift off the surface
 * (LA_CONTOUR_LIFT). Triangles of the surface reach beyond the contour on the screen, and rough
 * ones reach farther than those of an arc. */
#define OWN_LIFTS 3.0f

/* The lists of a frame, and the tables that they refer to. */
typedef struct Lists {
    __global const float* vertices;
    __global const uint* triangles;
    __global const ScreenFace* faces;
    __global const float* planes;
    __global const uint* occluders;
    __global const uint* groups;
    __global const float* blocks;
    __global const float* boxes;
    __global const uint* patches; /* patches of triangles; not read if there are no contours */
} Lists;

/* A segment on the screen, and in space. Along it counts s: 0 at p', 1 at q', linear on the
 * screen. */
typedef struct Line {
    float2 p, way; /* window position of p', and the way to q' */
    float nearness_p, nearness_way;
    float w_p, w_q;
    float t0, t1;
    uint vertex_p, vertex_q;
    float doubt;       /* of nearness, by rounding */
    float3 at_p, at_q; /* of the vertices, or lifted */
    /* The surface that a contour is on; LA_NO_SURFACE for other lines. own: true if only the faces
     * of this surface cut the line, false if only all others do. */
    uint patch;
    bool own;
} Line;

/* A piece of a line within a tile, in the tile's coordinates. Along the piece counts u: 0 to 1. */
typedef struct Piece {
    float2 a, b;
    float nearness_a, nearness_b;
    float s_a, s_b;
    float2 origin;
} Piece;

/* The parameter in space, 0 at the segment's vertex p and 1 at q, of place s on the screen. */
static float along_in_space(const Line* line, const float s) {
    const float near_share = s * line->w_p;
    return line->t0 + (line->t1 - line->t0) * (near_share / ((1.0f - s) * line->w_q + near_share));
}

/* Narrows u, from `low` to `high`, to where a function that is linear on the screen is not below 0.
 */
static void keep_above(const float at_a, const float at_b, float* low, float* high) {
    if (at_a < 0.0f && at_b < 0.0f) {
        *low = 1.0f;
        *high = 0.0f;
    } else if (at_a < 0.0f) {
        *low = fmax(*low, at_a / (at_a - at_b));
    } else if (at_b < 0.0f) {
        *high = fmin(*high, at_a / (at_a - at_b));
    }
}

/* As keep_above(), for a function that is linear in space, given at the segment's vertices. */
static void keep_above_in_space(const ExactParameters* args, const Line* line, const Piece* piece,
                                const float at_p, const float at_q, float* low, float* high) {
    const float more = at_q - at_p;
    const float at_a = at_p + more * along_in_space(line, piece->s_a);
    const float at_b = at_p + more * along_in_space(line, piece->s_b);
    const bool parallel = args->depth_rate > 0.0f;
    keep_above(parallel ? at_a : at_a * piece->nearness_a,
               parallel ? at_b : at_b * piece->nearness_b, low, high);
}

/* The side of the plane through the eye, b and c that a place is on: above 0 to the left of the way
 * from b to c, as the eye sees it. */
static float left_of(const ExactParameters* args, const float3 place, const float3 b,
                     const float3 c) {
    const float4 eye = to_float4(args->eye);
    const float3 origin = eye.w != 0.0f ? place : float3(0.0f, 0.0f, 0.0f);
    return pair_determinant(pair_difference(xyz(eye), origin), pair_difference(b, place),
                            pair_difference(c, place));
}

/* Narrows u, from `low` to `high`, to where the piece lies inside of the sides of face t in `which`
 * (bit k: the side opposite corner k). */
static void find_within_sides(const ExactParameters* args, const Lists* lists, const Line* line,
                              const Piece* piece, const uint t, const uint which, float* low,
                              float* high) {
    float3 corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = vload3(lists->triangles[3 * t + k], lists->vertices);
    const float3 normal = cross_product(corner[1] - corner[0], corner[2] - corner[0]);
    const bool turned = dot_product(normal, vload3(0, lists->planes + 4 * t)) > 0.0f;
    for (int k = 0; k < 3; ++k) {
        if ((which >> k & 1u) == 0) continue;
        const float3 first = corner[(k + 1) % 3], second = corner[(k + 2) % 3];
        const float3 b = turned ? second : first, c = turned ? first : second;
        keep_above_in_space(args, line, piece, left_of(args, line->at_p, b, c),
                            left_of(args, line->at_q, b, c), low, high);
    }
}

/* Narrows u, from `low` to `high`, to where rays hit face t beyond the near plane. */
static void keep_beyond_near(const ExactParameters* args, const Lists* lists, const Piece* piece,
                             const uint t, float* low, float* high) {
    if (lists->faces[t].kind != FACE_CROSSES || !(*low < *high)) return;
    Linear sides[3], near;
    crossing_sides(args, t, lists->vertices, lists->triangles, piece->origin, sides, &near);
    keep_above(near.a * piece->a.x + near.b * piece->a.y + near.c,
               near.a * piece->b.x + near.b * piece->b.y + near.c, low, high);
}

/* Narrows u, from `low` to `high`, to where the piece lies behind face t. It is decided in space,
 * by how far the line's ends lie behind the face's plane. */
static void find_behind(const ExactParameters* args, const Lists* lists, const Line* line,
                        const Piece* piece, const uint t, float* low, float* high) {
    const uint i0 = lists->triangles[3 * t], i1 = lists->triangles[3 * t + 1],
               i2 = lists->triangles[3 * t + 2];
    const uint p = line->vertex_p, q = line->vertex_q;
    const bool holds_p = i0 == p || i1 == p || i2 == p, holds_q = i0 == q || i1 == q || i2 == q;
    const float3 normal = vload3(0, lists->planes + 4 * t);
    const float behind_p =
        holds_p ? 0.0f : dot_product(normal, line->at_p - vload3(i0, lists->vertices));
    const float behind_q = holds_q ? 0.0f : behind_p + dot_product(normal, line->at_q - line->at_p);
    if (behind_p < args->contact && behind_q < args->contact) {
        *low = 1.0f;
        *high = 0.0f;
        return;
    }
    keep_above_in_space(args, line, piece, behind_p - args->contact, behind_q - args->contact, low,
                        high);
    keep_beyond_near(args, lists, piece, t, low, high);
}

/* The values of a linear function of LANES faces at a place. */
static lanes_float value_at(__global const float* coefficients, const float2 place) {
    return LOAD_LANES(coefficients) * place.x + (LOAD_LANES(coefficients + LA_GROUP) * place.y +
                                                 LOAD_LANES(coefficients + 2 * LA_GROUP));
}

/* Those lanes in `may_hide` whose faces may cut the contour. */
static uint cutting_lanes(const Lists* lists, const Line* line, __global const float* entries,
                          const uint may_hide) {
    uint cutting = 0;
    for (uint left = may_hide; left != 0; left &= left - 1u) {
        const uint lane = lowest_bit(left);
        const uint t = as_uint(entries[LA_ENTRY_FACE * LA_GROUP + lane]);
        if ((lists->patches[t] == line->patch) == line->own) cutting |= 1u << lane;
    }
    return cutting;
}

/* Takes the parts that LANES faces hide away from the piece. The piece must have parts. */
static void cut_by_lanes(const ExactParameters* args, const Lists* lists, const Line* line,
                         const Piece* piece, __global const float* entries, const float4 box,
                         const float farthest, const float doubt, const float least, Parts* parts) {
    /* Faces that hide nothing between these two places need no look. Beyond them nothing is
     * visible, or the place is so near an end of the segment that it counts as that end. */
    const float nothing = least < 0.5f ? NOTHING_AT_AN_END * least : 0.0f;
    const float2 ends =
        float2(fmax(parts->part[0].x, piece->s_a == 0.0f ? nothing : 0.0f),
               fmin(parts->part[parts->count - 1].y, piece->s_b == 1.0f ? 1.0f - nothing : 1.0f));
    lanes_int may = LOAD_LANES(entries + LA_ENTRY_LOW_X * LA_GROUP) <= box.z &&
                    LOAD_LANES(entries + LA_ENTRY_LOW_Y * LA_GROUP) <= box.w &&
                    LOAD_LANES(entries + LA_ENTRY_HIGH_X * LA_GROUP) >= box.x &&
                    LOAD_LANES(entries + LA_ENTRY_HIGH_Y * LA_GROUP) >= box.y &&
                    LOAD_LANES(entries + LA_ENTRY_NEAREST * LA_GROUP) >= farthest;
    if (!ANY(may)) return;
    /* Faces need no slack for ways beside lines. Slivers without a width of their own hide nothing
     * of such a way. */
    const bool beside = args->beside != 0;
    const float slack = beside ? 0.0f : args->slack;
    const float narrowest = beside ? args->slack * (least / SHORTEST_PART) : 0.0f;
    lanes_float at_a[3], at_b[3];
    lanes_int along[3];
    /* Ways beside lines have no place in space. */
    const float close = beside ? -1.0f : CLOSE_TO_SIDE;
    for (int k = 0; k < 3; ++k) {
        __global const float* side = entries + (LA_ENTRY_SIDES + 3 * k) * LA_GROUP;
        at_a[k] = value_at(side, piece->a) + slack;
        at_b[k] = value_at(side, piece->b) + slack;
        along[k] = fmax(fabs(at_a[k]), fabs(at_b[k])) < close;
        may = may && (at_a[k] >= 0.0f || at_b[k] >= 0.0f || along[k]);
    }
    if (!ANY(may)) return;
    lanes_float low = 0.0f, high = 1.0f;
    for (int k = 0; k < 3; ++k) {
        const lanes_float root = at_a[k] / (at_a[k] - at_b[k]);
        low = select(low, fmax(low, root), at_a[k] < 0.0f && !along[k]);
        high = select(high, fmin(high, root), at_b[k] < 0.0f && !along[k]);
    }
    may = may && low + narrowest < high && low < ends.y && high > ends.x;
    const lanes_float margin = LOAD_LANES(entries + LA_ENTRY_DOUBT * LA_GROUP) + doubt;
    __global const float* plane = entries + LA_ENTRY_PLANE * LA_GROUP;
    const lanes_float before_a = value_at(plane, piece->a) - piece->nearness_a;
    const lanes_float before_b = value_at(plane, piece->b) - piece->nearness_b;
    uint may_hide = LANE_BITS(may && fmax(before_a, before_b) >= -margin);
    if (line->patch != LA_NO_SURFACE) may_hide = cutting_lanes(lists, line, entries, may_hide);
    if (may_hide == 0) return;
    const lanes_int surely = fmin(before_a, before_b) >= margin;
    float lows[LANES], highs[LANES];
    const uint hides_surely = LANE_BITS(surely);
    const uint along_0 = LANE_BITS(along[0]), along_1 = LANE_BITS(along[1]),
               along_2 = LANE_BITS(along[2]);
    const uint is_close = along_0 | along_1 | along_2;
    STORE_LANES(low, lows);
    STORE_LANES(high, highs);
    const uint hides_whole =
        LANE_BITS(low <= 0.0f && high >= 1.0f) & may_hide & hides_surely & ~is_close;
    if (hides_whole != 0) {
        parts->count = 0;
        parts->end = 1.0f;
        return;
    }
    for (; may_hide != 0; may_hide &= may_hide - 1u) {
        const uint lane = lowest_bit(may_hide);
        const uint t = as_uint(entries[LA_ENTRY_FACE * LA_GROUP + lane]);
        float from = lows[lane], to = highs[lane];
        if (beside) {
            const bool may_cross = entries[LA_ENTRY_DOUBT * LA_GROUP + lane] == INFINITY;
            if (may_cross) keep_beyond_near(args, lists, piece, t, &from, &to);
        } else if ((hides_surely >> lane & 1u) == 0)
            find_behind(args, lists, line, piece, t, &from, &to);
        if ((is_close >> lane & 1u) != 0 && from < to) {
            const uint which =
                (along_0 >> lane & 1u) | (along_1 >> lane & 1u) << 1 | (along_2 >> lane & 1u) << 2;
            find_within_sides(args, lists, line, piece, t, which, &from, &to);
        }
        if (!(from < to)) continue;
        hide(parts, from <= 0.0f ? -1.0f : from, to >= 1.0f ? 2.0f : to, least);
        if (parts->count == 0) return;
    }
}

/* Takes the hidden parts of a piece in a tile away from its visible parts. The piece must have
 * some. */
static void cut_piece(const ExactParameters* args, const Lists* lists, const Line* line,
                      const Piece* piece, const uint tile, Parts* parts) {
    const float margin = 2.0f * args->slack;
    const float2 from = piece->a + (piece->b - piece->a) * parts->part[0].x;
    const float4 box = float4(fmin(from.x, piece->b.x) - margin, fmin(from.y, piece->b.y) - margin,
                              fmax(from.x, piece->b.x) + margin, fmax(from.y, piece->b.y) + margin);
    const float nearest = fmax(piece->nearness_a, piece->nearness_b);
    const float doubt = line->doubt + nearest * NEARNESS_DOUBT + projection_doubt(args, nearest);
    const float farthest = fmin(piece->nearness_a, piece->nearness_b) - doubt;
    const float2 way = piece->b - piece->a;
    const float least = SHORTEST_PART / sqrt(way.x * way.x + way.y * way.y);
    const uint first = lists->groups[tile], last = lists->groups[tile + 1];
    const uint stride = args->group_capacity + LA_GROUP;
    for (uint at = first; at < last; at += LANES) {
        __global const float* boxes = lists->boxes + at;
        if (boxes[LA_BOX_BEHIND * stride] < farthest) return;
        const lanes_int meets = LOAD_LANES(boxes + LA_ENTRY_LOW_X * stride) <= box.z &&
                                LOAD_LANES(boxes + LA_ENTRY_LOW_Y * stride) <= box.w &&
                                LOAD_LANES(boxes + LA_ENTRY_HIGH_X * stride) >= box.x &&
                                LOAD_LANES(boxes + LA_ENTRY_HIGH_Y * stride) >= box.y &&
                                LOAD_LANES(boxes + LA_ENTRY_NEAREST * stride) >= farthest;
        uint meeting = LANE_BITS(meets);
        if (last - at < LANES) meeting &= (1u << (last - at)) - 1u;
        for (; meeting != 0; meeting &= meeting - 1u) {
            const uint k = lowest_bit(meeting);
            __global const float* entries = lists->blocks + (size_t)(at + k) * LA_GROUP_FLOATS;
            for (uint lane = 0; lane < LA_GROUP; lane += LANES) {
                cut_by_lanes(args, lists, line, piece, entries + lane, box, farthest, doubt, least,
                             parts);
                if (parts->count == 0) return;
            }
        }
    }
}

static Piece piece_of(const Line* line, const float s_a, const float s_b, const float2 origin) {
    Piece piece;
    piece.a = line->p + line->way * s_a - origin;
    piece.b = line->p + line->way * s_b - origin;
    piece.nearness_a = line->nearness_p + line->nearness_way * s_a;
    piece.nearness_b = line->nearness_p + line->nearness_way * s_b;
    piece.s_a = s_a;
    piece.s_b = s_b;
    piece.origin = origin;
    return piece;
}

/* Finds the visible parts of the segment from s_a to s_b, all in one tile. lifted: a contour as its
 * own surface hides it; null for other lines. */
static void find_in_tile(const ExactParameters* args, const Lists* lists, const Line* line,
                         const Line* lifted, const int2 tile, const float s_a, const float s_b,
                         Found* found) {
    const uint index = (uint)(tile.y * args->tiles.v[0] + tile.x);
    const float2 origin = float2((float)tile.x, (float)tile.y) * args->tile_size;
    const Piece piece = piece_of(line, s_a, s_b, origin);
    const float nearest = fmax(piece.nearness_a, piece.nearness_b);
    /* A contour may lie a little behind a large face of its own. */
    if (lifted == 0 && nearest < as_float(lists->occluders[index])) return;
    Parts parts;
    for (float from = 0.0f; from < 1.0f; from = parts.end) {
        begin_parts(&parts, from);
        cut_piece(args, lists, line, &piece, index, &parts);
        if (lifted != 0 && parts.count > 0) {
            const Piece above = piece_of(lifted, s_a, s_b, origin);
            cut_piece(args, lists, lifted, &above, index, &parts);
        }
        for (int k = 0; k < parts.count; ++k) {
            const float2 part = parts.part[k];
            add_part(found, float2(s_a + (s_b - s_a) * part.x,
                                   part.y == 1.0f ? s_b : s_a + (s_b - s_a) * part.y));
        }
    }
}

/* Where a line that starts at p, in one coordinate, leaves the tile. */
static float leaves_at(const float p, const float way, const int tile, const float size) {
    if (way > 0.0f) return ((float)(tile + 1) * size - p) / way;
    if (way < 0.0f) return ((float)tile * size - p) / way;
    return 2.0f;
}

/* A walk along a segment from tile to tile. It has come to `tile`, which has the segment's part
 * from `from` to `to`. */
typedef struct Walk {
    int2 tile, next;
    float from, to;
} Walk;

static Walk begin_walk(const ExactParameters* args, const Line* line) {
    Walk walk;
    walk.next = clamp(convert_int2_rtn(line->p * (1.0f / args->tile_size)), int2(0, 0),
                      to_int2(args->tiles) - 1);
    walk.tile = walk.next;
    walk.from = walk.to = 0.0f;
    return walk;
}

/* Goes on to the next tile that has more of the segment than a point. Returns false if there is
 * none. */
static bool walk_on(const ExactParameters* args, const Line* line, Walk* walk) {
    const int2 tiles = to_int2(args->tiles);
    while (walk->to < 1.0f) {
        walk->tile = walk->next;
        const float x = leaves_at(line->p.x, line->way.x, walk->tile.x, args->tile_size);
        const float y = leaves_at(line->p.y, line->way.y, walk->tile.y, args->tile_size);
        if (x <= y)
            walk->next.x += line->way.x > 0.0f ? 1 : -1;
        else
            walk->next.y += line->way.y > 0.0f ? 1 : -1;
        const bool outside = walk->next.x < 0 || walk->next.y < 0 || walk->next.x >= tiles.x ||
                             walk->next.y >= tiles.y;
        const float end = outside ? 1.0f : fmin(fmin(x, y), 1.0f);
        if (!(end > walk->to)) continue;
        walk->from = walk->to;
        walk->to = end;
        return true;
    }
    return false;
}

/* Finds the visible parts of the segment, tile by tile. */
static void find_visible(const ExactParameters* args, const Lists* lists, const Line* line,
                         const Line* lifted, Found* found) {
    Walk walk = begin_walk(args, line);
    while (walk_on(args, line, &walk))
        find_in_tile(args, lists, line, lifted, walk.tile, walk.from, walk.to, found);
    close_part(found);
}

static float2 window_place(const ExactParameters* args, const float4 clip) {
    return (xy(clip) / clip.w + 1.0f) * (to_float2(args->viewport) * 0.5f);
}

/* A segment between its clipped ends; at_p, at_q: its vertices. */
static Line line_between(const ExactParameters* args, __global const Segment* segment,
                         __global const ClippedSegment* clipped, const float4 p, const float4 q,
                         const float3 at_p, const float3 at_q) {
    Line line;
    line.p = window_place(args, p);
    line.way = window_place(args, q) - line.p;
    line.nearness_p = nearness_of(args, p);
    const float nearness_q = nearness_of(args, q);
    line.nearness_way = nearness_q - line.nearness_p;
    line.w_p = p.w;
    line.w_q = q.w;
    line.t0 = clipped->t0;
    line.t1 = clipped->t1;
    line.vertex_p = segment->p;
    line.vertex_q = segment->q;
    line.at_p = at_p;
    line.at_q = at_q;
    line.doubt = fmax(line.nearness_p, nearness_q) * FEW_ULPS;
    line.patch = LA_NO_SURFACE;
    line.own = false;
    return line;
}

static bool is_contour(const ExactParameters* args, __global const Segment* segment) {
    return args->beside == 0 && (segment->tag & LA_TAG_CONTOUR) != 0;
}

static Line line_of(const ExactParameters* args, const Lists* lists,
                    __global const Segment* segment, __global const ClippedSegment* clipped) {
    Line line =
        line_between(args, segment, clipped, vload4(0, clipped->p), vload4(0, clipped->q),
                     vload3(segment->p, lists->vertices), vload3(segment->q, lists->vertices));
    if (is_contour(args, segment)) line.patch = lists->patches[segment->face_a];
    return line;
}

/* A contour, lifted so far that its own surface does not hide it where it should be seen. */
static Line lifted_line(const ExactParameters* args, const Lists* lists,
                        __global const Segment* segment, __global const ClippedSegment* clipped,
                        const Line* line) {
    const Matrix m = to_matrix(args->clip_from_world);
    const float3 above_p =
        lifted_vertex(segment, segment->p, args->lift, OWN_LIFTS, lists->vertices);
    const float3 above_q =
        lifted_vertex(segment, segment->q, args->lift, OWN_LIFTS, lists->vertices);
    const float4 p = transform_point(m, above_p), way = transform_point(m, above_q) - p;
    const float4 from = p + way * line->t0, to = p + way * line->t1;
    Line lifted = *line;
    if (from.w > 0.0f && to.w > 0.0f)
        lifted = line_between(args, segment, clipped, from, to, above_p, above_q);
    lifted.patch = line->patch;
    lifted.own = true;
    return lifted;
}

/* The segment that clipped segment i is a part of, or runs beside. */
static uint segment_of(const ExactParameters* args, const uint i, __global const uint* seen) {
    return args->beside != 0 ? seen[i / args->beside] : i;
}

/* True if clipped segment i has nothing to be looked for. */
static bool is_absent(const ExactParameters* args, const uint i, __global const Segment* segment,
                      __global const ClippedSegment* clipped, __global const uint* arcs) {
    const bool absent = args->beside != 0 ? clipped[i].p[3] == 0.0f : arcs[i + 1] == arcs[i];
    return absent || (segment->tag & LA_TAG_BURIED) != 0;
}

#define LISTS                                                                                      \
    { vertices, triangles, faces, planes, occluders, groups, blocks, boxes, patches }

/* counts: visible parts of each segment; kept: the first two of them. */
KERNEL(visible_count, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    counts[i] = 0;
    if (!lists_fit(&args, ends[tiles * args.chunks], groups[tiles])) return;
    const Lists lists = LISTS;
    __global const Segment* segment = segments + segment_of(&args, i, seen);
    if (is_absent(&args, i, segment, clipped, arcs)) return;
    const Line line = line_of(&args, &lists, segment, clipped + i);
    const bool contour = is_contour(&args, segment);
    const Line lifted = contour ? lifted_line(&args, &lists, segment, clipped + i, &line) : line;
    Found found = nothing_found(line.way, 0);
    find_visible(&args, &lists, &line, contour ? &lifted : 0, &found);
    counts[i] = found.count;
    vstore4(found.kept, i, kept);
}

/* spans: start and end of the visible parts of all segments, 0 at p' and 1 at q', linear on the
 * screen. offsets: the scanned counts. */
KERNEL(visible_write, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || offsets[args.count] > args.span_capacity) return;
    const uint first = offsets[i];
    const uint count = offsets[i + 1] - first;
    if (count == 0) return;
    __global float* out = spans + 2 * (size_t)first;
    const float4 two = vload4(i, kept);
    vstore2(xy(two), 0, out);
    if (count == 2) vstore2(zw(two), 1, out);
    if (count <= 2) return;
    const Lists lists = LISTS;
    __global const Segment* segment = segments + segment_of(&args, i, seen);
    const Line line = line_of(&args, &lists, segment, clipped + i);
    const bool contour = is_contour(&args, segment);
    const Line lifted = contour ? lifted_line(&args, &lists, segment, clipped + i, &line) : line;
    Found found = nothing_found(line.way, out);
    find_visible(&args, &lists, &line, contour ? &lifted : 0, &found);
}

/* counts: pieces of each segment. */
KERNEL(visible_pieces, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const uint tiles = (uint)(args.tiles.v[0] * args.tiles.v[1]);
    counts[i] = 0;
    if (!lists_fit(&args, ends[tiles * args.chunks], groups[tiles])) return;
    const Lists lists = LISTS;
    __global const Segment* segment = segments + segment_of(&args, i, seen);
    if (is_absent(&args, i, segment, clipped, arcs)) return;
    const Line line = line_of(&args, &lists, segment, clipped + i);
    uint count = 0;
    for (Walk walk = begin_walk(&args, &line); walk_on(&args, &line, &walk);) ++count;
    counts[i] = count;
}

/* The segment, of `count`, that has piece k: the last whose pieces begin at k or before. */
static uint segment_with_piece(const uint k, const uint count, __global const uint* piece_offsets) {
    uint low = 0, high = count;
    while (high - low > 1u) {
        const uint middle = low + (high - low) / 2u;
        if (piece_offsets[middle] <= k)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Finds the parts of a piece as they are, neither joined nor moved to the ends of the segment. */
static Found find_in_piece(const ExactParameters* args, const Lists* lists, const uint k,
                           __global const Segment* segments, __global const uint* seen,
                           __global const ClippedSegment* clipped,
                           __global const uint* piece_offsets, __global float* out) {
    const uint i = segment_with_piece(k, args->count, piece_offsets);
    __global const Segment* segment = segments + segment_of(args, i, seen);
    const Line line = line_of(args, lists, segment, clipped + i);
    const bool contour = is_contour(args, segment);
    const Line lifted = contour ? lifted_line(args, lists, segment, clipped + i, &line) : line;
    Walk walk = begin_walk(args, &line);
    for (uint left = k - piece_offsets[i] + 1u; left > 0; --left) walk_on(args, &line, &walk);
    Found found = nothing_found(line.way, out);
    found.gap = -1.0f;
    find_in_tile(args, lists, &line, contour ? &lifted : 0, walk.tile, walk.from, walk.to, &found);
    close_part(&found);
    return found;
}

/* counts: parts of each piece; piece_kept: the first two of them. */
KERNEL(visible_cut, ExactParameters) {
    const uint k = (uint)get_global_id(0);
    if (k >= piece_offsets[args.count]) return;
    const Lists lists = LISTS;
    const Found found = find_in_piece(&args, &lists, k, segments, seen, clipped, piece_offsets, 0);
    counts[k] = found.count;
    vstore4(found.kept, k, piece_kept);
}

/* raw_parts: the parts of all pieces, in their order. */
KERNEL(visible_parts, ExactParameters) {
    const uint k = (uint)get_global_id(0);
    if (k >= piece_offsets[args.count]) return;
    const uint first = part_offsets[k], count = part_offsets[k + 1] - first;
    if (count == 0) return;
    __global float* out = raw_parts + 2 * (size_t)first;
    const float4 two = vload4(k, piece_kept);
    vstore2(xy(two), 0, out);
    if (count == 2) vstore2(zw(two), 1, out);
    if (count <= 2) return;
    const Lists lists = LISTS;
    find_in_piece(&args, &lists, k, segments, seen, clipped, piece_offsets, out);
}

/* Joins the parts of clipped segment i. out null: counts them only. */
static uint join_parts(const ExactParameters* args, const uint i,
                       __global const ClippedSegment* clipped, __global const uint* piece_offsets,
                       __global const uint* part_offsets, __global const float* raw_parts,
                       __global float* out) {
    const uint first = part_offsets[piece_offsets[i]], last = part_offsets[piece_offsets[i + 1]];
    if (first == last) return 0;
    const float2 p = window_place(args, vload4(0, clipped[i].p));
    Found found = nothing_found(window_place(args, vload4(0, clipped[i].q)) - p, out);
    for (uint k = first; k < last; ++k) add_part(&found, vload2(k, raw_parts));
    close_part(&found);
    return found.count;
}

/* counts: visible parts of each segment. */
KERNEL(visible_join, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    counts[i] = join_parts(&args, i, clipped, piece_offsets, part_offsets, raw_parts, 0);
}

/* spans: as visible_write leaves them. */
KERNEL(visible_spans, ExactParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count || offsets[args.count] > args.span_capacity) return;
    join_parts(&args, i, clipped, piece_offsets, part_offsets, raw_parts,
               spans + 2 * (size_t)offsets[i]);
}
