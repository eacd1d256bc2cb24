/* Tables and scalars of `carry`. Valid in OpenCL C and in C++, as segment_table.h is. */
#ifndef LINEATLAS_CARRY_TABLES_H
#define LINEATLAS_CARRY_TABLES_H

typedef struct CarryParameters {
    la_uint count;    /* silhouettes; for carry_runs the runs that there is room for */
    la_uint first;    /* of them in the segment table */
    la_vec2 viewport; /* pixels */
    la_uint frame;    /* number of this frame; only what the frame before it remembered counts */
    la_uint limit;    /* by how much a coordinate may shift, 1/256 pixels; 0: none may */
} CarryParameters;

/* What `memory` holds of each candidate: its coordinates at the clipped start and end in 1/256
 * pixels, the clip parameters of both with 16 bits each, and a stamp: 2 frame, and 1 more if the
 * candidate ran the other way. */
#define LA_MEMORY_START 0u
#define LA_MEMORY_END 1u
#define LA_MEMORY_RANGE 2u
#define LA_MEMORY_STAMP 3u
#define LA_MEMORY_WORDS 4u

/* Lists stay lists: */
/* clang-format off */
#define carry_recall_tables(in, out, inout, unordered) \
    in(Segment, segments) in(ClippedSegment, clipped) in(uint, arcs) in(uint, origins) \
    in(int, memory) out(uint, lengths) out(uint, found) out(int, recalled)
#define carry_keep_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, lengths) in(uint, found) in(int, recalled) out(uint, kept)
#define carry_breaks_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, lengths) in(int, recalled) in(uint, kept) in(uint, list) \
    out(uint, breaks) out(uint, means)
#define carry_pieces_tables(in, out, inout, unordered) \
    in(uint, kept) in(uint, breaks) out(uint, pieces)
#define carry_settle_tables(in, out, inout, unordered) \
    in(uint, kept) in(uint, breaks) in(uint, means) in(uint, pieces) out(int, shifts)
#define carry_place_tables(in, out, inout, unordered) \
    in(Segment, segments) in(ClippedSegment, clipped) in(uint, arcs) in(uint, origins) \
    in(uint, lengths) in(int, recalled) in(uint, kept) in(uint, list) in(uint, breaks) \
    in(int, shifts) out(int, carried) inout(int, memory)
#define carry_runs_tables(in, out, inout, unordered) \
    in(uint, arcs) in(int, carried) in(FrameRecord, record) inout(Run, runs)
/* clang-format on */

#endif
