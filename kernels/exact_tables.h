/* Tables and scalars of the exact method (exact.h). Valid in OpenCL C and in C++, as
 * segment_table.h is. */
#ifndef LINEATLAS_EXACT_TABLES_H
#define LINEATLAS_EXACT_TABLES_H

/* A triangle on the screen. */
typedef struct ScreenFace {
    float low[2], high[2]; /* the box around its part beyond the near plane, pixels */
    float nearest;         /* its greatest nearness, see nearness_of() */
    la_uint kind;          /* FACE_* */
} ScreenFace;

/* A face in the list of a tile. */
typedef struct Entry {
    la_uint face;   /* triangle */
    float nearness; /* the greatest in the tile */
    la_uint key;    /* the key by which the list is sorted; before that the tile (tile_lists.cl) */
} Entry;

/* Keys by which the faces of a tile are sorted. */
#define LA_LIST_KEYS 256u

/* Faces of a tile's list that stand together: LA_ENTRY_FLOATS rows of LA_GROUP numbers. */
#define LA_GROUP 16u
#define LA_ENTRY_LOW_X 0u
#define LA_ENTRY_LOW_Y 1u
#define LA_ENTRY_HIGH_X 2u
#define LA_ENTRY_HIGH_Y 3u
#define LA_ENTRY_NEAREST 4u
#define LA_ENTRY_SIDES 5u  /* a, b, c of each of three */
#define LA_ENTRY_PLANE 14u /* a, b, c */
#define LA_ENTRY_DOUBT 17u
#define LA_ENTRY_FACE 18u /* the bits of an uint: the triangle */
#define LA_ENTRY_FLOATS 19u
#define LA_GROUP_FLOATS (LA_GROUP * LA_ENTRY_FLOATS)
/* The box of a group: the first five of these rows, and the greatest nearness in this and all later
 * groups of the tile. */
#define LA_BOX_BEHIND 5u
#define LA_BOX_FLOATS 6u

typedef struct ExactParameters {
    la_uint count; /* segments; for surfaces_occluders and surfaces_batches: batches */
    la_uint vertex_count, triangle_count;
    la_mat4 clip_from_world;
    la_vec4 eye;      /* homogeneous, as in FacingParameters; a unit vector if its w is 0 */
    la_vec2 viewport; /* pixels */
    la_ivec2 tiles;
    float tile_size; /* pixels */
    float contact;   /* a point nearer than this to a face touches it; model units */
    /* Faces are made wider by this on the screen, in pixels. It is about the rounding of a position
     * there. Without it lines would shine through where one face ends in the middle of another's
     * side. */
    float slack;
    float depth_rate; /* clip z per model unit in a parallel view; 0 in a perspective view */
    float rounding;   /* the most by which rounding changes the depth coordinate in clip space */
    la_uint slices;   /* work-items that share the rows of tiles of each triangle */
    la_uint chunk;    /* triangles per work-item of tile_lists */
    la_uint chunks;   /* chunks of triangles; 1: counts are of each tile alone */
    la_uint entry_capacity, group_capacity, span_capacity;
    /* The clipped segments are this many ways beside each segment that `seen` lists, see
     * outline_push. Every face over such a way hides it. 0: the clipped segments are the segments
     * themselves. */
    la_uint beside;
    la_uint lift;    /* places from a contour's vertex to the same vertex lifted off its surface; 0:
                        no contours */
    la_uint batched; /* number of first triangles whose batches have states */
    la_uint keeps_hidden; /* for surfaces_batches; 1: hidden batches are looked at all the same */
} ExactParameters;

typedef struct OutlineParameters {
    la_uint count; /* segments; for outline_push and outline_push_in those that are seen */
    la_vec2 viewport;
    float reach;      /* pixels from a line to the place beside it */
    float depth;      /* pixels that a body must be deep on the other side of its outline */
    la_uint parallel; /* 1: a parallel view */
    la_uint capacity; /* parts that there is room for */
    la_mat4 clip_from_world;
    la_uint lift; /* as in ExactParameters */
} OutlineParameters;

/* Ways beside a segment: one on either side, then for each of these LA_OUTLINE_STEPS on the other
 * side of the segment. */
#define LA_OUTLINE_STEPS 2u
#define LA_OUTLINE_BESIDE 2u
#define LA_OUTLINE_WITHIN (2u * LA_OUTLINE_STEPS)
/* How far towards a corner a body may lack its depth, as a multiple of that depth. */
#define LA_OUTLINE_CORNER 3.0f

typedef struct OutlineSamplesParameters {
    la_uint count; /* segments */
    la_vec2 viewport;
    float reach, depth; /* as in OutlineParameters */
    la_ivec2 depth_size;
    float depth_scale; /* depth texels per pixel */
    la_uint numbered;  /* 1: `numbers` says what is seen; 0: `depth` does */
    la_uint sample_capacity;
    la_uint part_capacity;
} OutlineSamplesParameters;

typedef struct PensParameters {
    la_uint outlines; /* 0: nothing is outline, and no parts are read */
    la_uint first;    /* first segment that is a silhouette; `origins` says of which candidate */
    la_uint run_capacity, drawn_capacity;
} PensParameters;

/* SpansParameters.wanted, a sum of: */
#define LA_WANTS_VISIBLE 1u
#define LA_WANTS_HIDDEN 2u
#define LA_WANTS_NO_DOTS 4u /* no parts of segments that are dots, see is_dot() */

typedef struct SpansParameters {
    la_uint count; /* segments */
    la_vec2 viewport;
    float half_width; /* as in CompactParameters */
    la_uint wanted;   /* LA_WANTS_* */
    la_uint block;    /* segments per work-item */
    la_uint blocks;
    la_uint span_capacity;
    la_uint capacity; /* of runs, or of intervals */
} SpansParameters;

/* Lists stay lists: */
/* clang-format off */
#define EXACT_MODEL_TABLES(in) in(float, vertices) in(uint, triangles)
#define EXACT_LIST_TABLES(in) \
    EXACT_MODEL_TABLES(in) \
    in(ScreenFace, faces) in(float, planes) in(uint, occluders) in(uint, ends) in(uint, groups) \
    in(float, blocks) in(float, boxes)

#define surfaces_vertices_tables(in, out, inout, unordered) in(float, vertices) out(float, screen)
#define surfaces_occluders_tables(in, out, inout, unordered) \
    EXACT_MODEL_TABLES(in) in(float, screen) in(Batch, batches) inout(uint, occluders)
#define surfaces_faces_tables(in, out, inout, unordered) \
    EXACT_MODEL_TABLES(in) in(float, screen) in(uchar, states) out(ScreenFace, faces) \
        out(float, planes) inout(uint, occluders)
#define surfaces_boxes_tables(in, out, inout, unordered) \
    EXACT_MODEL_TABLES(in) out(Batch, batches)
#define surfaces_batches_tables(in, out, inout, unordered) \
    in(Batch, batches) in(uint, occluders) out(uchar, states)
#define tile_lists_count_tables(in, out, inout, unordered) \
    EXACT_MODEL_TABLES(in) in(float, screen) in(ScreenFace, faces) in(float, planes) \
    in(uint, occluders) in(uchar, states) inout(uint, counts)
#define tile_lists_groups_tables(in, out, inout, unordered) in(uint, offsets) out(uint, groups)
#define tile_lists_fill_tables(in, out, inout, unordered) \
    EXACT_MODEL_TABLES(in) in(float, screen) in(ScreenFace, faces) in(float, planes) \
    in(uint, occluders) in(uchar, states) inout(uint, ends) unordered(Entry, entries) \
    inout(uint, ranges)
#define tile_lists_arrange_tables(in, out, inout, unordered) \
    EXACT_MODEL_TABLES(in) in(float, screen) in(ScreenFace, faces) in(float, planes) \
    in(uint, ends) inout(Entry, entries) in(uint, groups) out(float, blocks) \
    out(float, boxes)
#define tile_lists_keys_tables(in, out, inout, unordered) \
    in(ScreenFace, faces) in(uint, ends) in(uint, groups) in(uint, ranges) \
    inout(Entry, entries) inout(uint, keys)
#define tile_lists_place_tables(in, out, inout, unordered) \
    in(uint, ends) in(uint, groups) in(Entry, entries) inout(uint, keys) unordered(Entry, placed)
#define tile_lists_sort_tables(in, out, inout, unordered) \
    in(uint, ends) in(uint, groups) in(uint, keys) in(Entry, placed) out(Entry, entries)
#define tile_lists_write_tables(in, out, inout, unordered) \
    EXACT_MODEL_TABLES(in) in(float, screen) in(ScreenFace, faces) in(float, planes) \
    in(uint, ends) in(uint, groups) in(Entry, entries) out(float, blocks)
#define tile_lists_boxes_tables(in, out, inout, unordered) \
    in(uint, ends) in(uint, groups) in(float, blocks) out(float, boxes)
#define tile_lists_behind_tables(in, out, inout, unordered) \
    in(uint, ends) in(uint, groups) inout(float, boxes)
#define visible_count_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, seen) in(ClippedSegment, clipped) in(uint, arcs) \
    in(uint, patches) EXACT_LIST_TABLES(in) out(uint, counts) out(float, kept)
#define visible_write_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, seen) in(ClippedSegment, clipped) in(uint, patches) \
    EXACT_LIST_TABLES(in) in(uint, offsets) in(float, kept) out(float, spans)
#define PIECE_TABLES(in) \
    in(Segment, segments) in(uint, seen) in(ClippedSegment, clipped) in(uint, patches) \
    EXACT_LIST_TABLES(in)
#define visible_pieces_tables(in, out, inout, unordered) \
    PIECE_TABLES(in) in(uint, arcs) out(uint, counts)
#define visible_cut_tables(in, out, inout, unordered) \
    PIECE_TABLES(in) in(uint, piece_offsets) out(uint, counts) out(float, piece_kept)
#define visible_parts_tables(in, out, inout, unordered) \
    PIECE_TABLES(in) in(uint, piece_offsets) in(uint, part_offsets) in(float, piece_kept) \
    out(float, raw_parts)
#define visible_join_tables(in, out, inout, unordered) \
    in(ClippedSegment, clipped) in(uint, piece_offsets) in(uint, part_offsets) \
    in(float, raw_parts) out(uint, counts)
#define visible_spans_tables(in, out, inout, unordered) \
    in(ClippedSegment, clipped) in(uint, piece_offsets) in(uint, part_offsets) \
    in(float, raw_parts) in(uint, offsets) out(float, spans)
#define spans_count_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, arcs) in(uint, span_offsets) in(float, spans) out(uint, counts)
#define spans_runs_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(uint, span_offsets) in(float, spans) in(uint, block_offsets) \
    out(Run, runs) out(FrameRecord, record)
#define spans_intervals_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(float, vertices) in(uint, span_offsets) in(float, spans) \
    in(uint, block_offsets) out(Interval, intervals) out(uint, interval_total)

#define outline_seen_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, arcs) in(uint, span_offsets) out(uint, numbers)
#define outline_push_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, seen) in(float, vertices) in(ClippedSegment, clipped) \
    inout(ClippedSegment, pushed)
#define outline_push_in_tables(in, out, inout, unordered) \
    in(uint, seen) in(ClippedSegment, clipped) in(uint, beside_offsets) inout(ClippedSegment, pushed)
#define outline_parts_count_tables(in, out, inout, unordered) \
    in(uint, numbers) in(uint, arcs) in(uint, beside_offsets) in(float, beside) in(uint, within_offsets) in(float, within) \
    out(uint, counts)
#define outline_parts_write_tables(in, out, inout, unordered) \
    in(uint, numbers) in(uint, arcs) in(uint, beside_offsets) in(float, beside) in(uint, within_offsets) in(float, within) \
    in(uint, part_offsets) out(float, parts)
#define outline_samples_count_tables(in, out, inout, unordered) \
    in(Segment, segments) in(ClippedSegment, clipped) in(uint, offsets) in(float, depth) \
    in(uint, numbers) out(uint, counts)
#define outline_samples_write_tables(in, out, inout, unordered) \
    in(Segment, segments) in(ClippedSegment, clipped) in(uint, offsets) in(float, depth) \
    in(uint, numbers) in(uint, part_offsets) out(float, parts)
#define pens_count_tables(in, out, inout, unordered) \
    in(Run, runs) in(FrameRecord, record) in(uint, segment_pens) in(uint, origins) \
    in(uint, part_offsets) in(float, parts) out(uint, counts)
#define pens_write_tables(in, out, inout, unordered) \
    in(Run, runs) in(FrameRecord, record) in(uint, segment_pens) in(uint, origins) \
    in(uint, part_offsets) in(float, parts) in(uint, run_offsets) out(Run, drawn) out(FrameRecord, drawn_record)

/* clang-format on */
#endif
