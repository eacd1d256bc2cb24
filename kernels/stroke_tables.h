/* What the kernels of `strokes` work on; included by kernels.h. */
#ifndef LINEATLAS_STROKE_TABLES_H
#define LINEATLAS_STROKE_TABLES_H

#include "stroke_tile.h"

/* Lists stay lists: */
/* clang-format off */
typedef struct StrokeListParameters {
    la_ivec2 tiles;      /* of the whole picture */
    float reach;         /* pixels from the spine of a run to where its coverage is 0 */
    la_uint chunks;      /* into which the runs are divided, in their order */
    la_uint capacity;    /* of `entries` */
} StrokeListParameters;
#define strokes_count_tables(in, out, inout, unordered) \
    in(Run, runs) in(FrameRecord, record) inout(uint, counts)
#define strokes_list_tables(in, out, inout, unordered) \
    in(Run, runs) in(FrameRecord, record) inout(uint, ends) out(uint, entries) \
    out(uint, total)

/* StrokesParameters.end_kinds: what has round ends, and whether ends are cut. */
#define LA_STROKES_ROUND_JOINS 1u  /* joins */
#define LA_STROKES_ROUND_CAPS 2u   /* where visibility ends */
#define LA_STROKES_ROUND_PATHS 4u  /* where the path does */
#define LA_STROKES_EXACT_ENDS 8u   /* ends that are not round are cut; else visibility fades out */

#define LA_ALL_PENS 0xFFFFFFFFu

typedef struct StrokesParameters {
    la_uint count;       /* runs that there is room for */
    la_ivec2 tiles;      /* of the whole picture */
    la_uint chunks;      /* as in StrokeListParameters */
    la_uint capacity;    /* of `entries` */
    la_ivec2 first;      /* the first tile of the part that is drawn */
    la_ivec2 columns;    /* tiles of that part, across and up */
    la_ivec4 part;       /* its first pixel and its size */
    la_uint begin, end;  /* what of every tile's list is drawn */
    la_uint again;       /* 1: strokes are drawn over what `coverage` holds; else it is cleared */
    la_uint layer;       /* which of `coverage` is drawn, */
    la_uint pitch;       /* of so many bytes each */
    float half_width, opacity;
    la_uint end_kinds;   /* LA_STROKES_* */
    la_uint hidden;      /* 1: draws what is not visible */
    la_uint pen;         /* whose runs are drawn, or LA_ALL_PENS */
    la_uint mark_length; /* values of `mark`, over `repeat` pixels along a stroke; 0: it is solid */
    float per_repeat;    /* 1 / repeat */
    la_ivec2 cells;      /* of `weights`, as `density` leaves them; none: all lines are drawn whole */
    float per_cell;      /* cells per pixel */
} StrokesParameters;
#define strokes_tiles_tables(in, out, inout, unordered) \
    in(Run, runs) in(uint, ends) in(uint, entries) in(uchar, alpha) in(float, mark) \
    in(float, weights) \
    inout(uchar, coverage) inout(uint, shown)
/* The numbers of a run's stroke that are found once, not by each pixel. */
typedef struct StrokeBox {
    float low[2], high[2]; /* it covers no pixels but those above `low` and up to `high` */
    la_uint flags;         /* LA_STROKE_*; 0: it is another pen's */
    float opacity;
} StrokeBox;
#define LA_STROKE_DRAWN 1u   /* by the pen that is drawn */
#define LA_STROKE_EVEN 2u    /* its visibility is 1 all along */
#define LA_STROKE_THINNED 4u /* `density` leaves out shares of it that change along it */
#define strokes_boxes_tables(in, out, inout, unordered) \
    in(Run, runs) in(FrameRecord, record) in(uchar, alpha) in(float, weights) \
    out(StrokeBox, boxes)
#define strokes_pixels_tables(in, out, inout, unordered) \
    in(Run, runs) in(StrokeBox, boxes) in(uint, ends) in(uint, entries) in(uchar, alpha) \
    in(float, mark) in(float, weights) inout(uchar, coverage) inout(uint, shown)
/* clang-format on */

#endif
