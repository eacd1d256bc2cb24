/* The numbers in the members of tables: kinds, flags and what they mean. Nothing but defines, which
 * OpenCL C, C++ and GLSL read. */
#ifndef LINEATLAS_FLAGS_H
#define LINEATLAS_FLAGS_H

/* Line kinds; bit 1 << kind selects one in a kind mask. */
#define LA_KIND_CREASE 0u
#define LA_KIND_BOUNDARY 1u
#define LA_KIND_MATERIAL 2u
#define LA_KIND_SILHOUETTE 3u
#define LA_KIND_FILE 4u
#define LA_KIND_INTERSECTION 5u
#define LA_KIND_SECTION 6u
#define LA_KIND_HATCHING 7u
#define LA_KIND_RIDGE 8u
#define LA_KIND_VALLEY 9u
#define LA_KIND_TANGENT 10u
#define LA_KIND_CENTRE 11u
#define LA_KIND_TRAIL 12u
#define LA_KIND_COUNT 13u

/* Kind masks: lines that show the shape of a surface, and all lines that run within faces. */
#define LA_KINDS_OF_SHAPE (1u << LA_KIND_RIDGE | 1u << LA_KIND_VALLEY)
#define LA_KINDS_WITHIN (1u << LA_KIND_INTERSECTION | LA_KINDS_OF_SHAPE | 1u << LA_KIND_CENTRE)

/* Kinds of line that a drawing has beside its edges: none of them is ever an outline. */
#define LA_KINDS_BESIDE                                                                            \
    (1u << LA_KIND_FILE | 1u << LA_KIND_HATCHING | 1u << LA_KIND_CENTRE | 1u << LA_KIND_TRAIL)

/* Segment.tag: the kind in the low bits, then flags. */
#define LA_TAG_KIND_MASK 0xFu
#define LA_TAG_CLOSED 0x200u /* the path is a loop: its last segment continues in its first */
#define LA_TAG_CONTOUR 0x20u /* of a frame: a silhouette of a smooth surface, see contour.cl */
#define LA_TAG_SOLID 0x40u   /* of what contours run through: a closed part, wound outwards */
/* The same, for a surface that is undesigned: its triangles are rough. */
#define LA_TAG_UNDESIGNED 0x400u
/* Of a frame: a contour that its own part hides, and a contour that is seen from the back of its
 * surface. */
#define LA_TAG_BURIED 0x80u
#define LA_TAG_UNDERSIDE 0x100u
#define LA_TAG_LONE 0x10u /* touches no other segment: dropped when sub-pixel (§4.1) */

/* An edge of a triangle that runs against the triangle's winding. */
#define LA_CONTOUR_TURNED 0x80000000u

/* Segment.face_a, face_b: a triangle index, or LA_NO_FACE. LA_FACE_FLIPPED in face_b says that its
 * winding disagrees with face_a's, so that its facing must be negated before the two are compared.
 */
#define LA_NO_FACE 0xFFFFFFFFu
#define LA_FACE_FLIPPED 0x80000000u
#define LA_FACE_INDEX 0x7FFFFFFFu

/* Run.flags: what either end of a run or a stroke is. */
#define LA_END_CLIPPED 0u /* the viewport ends here: cut square */
#define LA_END_JOIN 1u    /* the path goes on: cut along the bisector with the next segment */
#define LA_END_ROUND 2u   /* the path goes on, but too sharply for a join: round, overlapping */
#define LA_END_HIDDEN 3u  /* visibility ends here */
#define LA_END_PATH 4u    /* the path ends here */
#define LA_END_MASK 7u
#define LA_RUN_START_SHIFT 0u /* of the run */
#define LA_RUN_END_SHIFT 3u
#define LA_STROKE_START_SHIFT 6u /* of the stroke that the run is a part of */
#define LA_STROKE_END_SHIFT 9u
#define LA_RUN_SOLID 0x8000u /* visible all along: the atlas has no samples of it */
#define LA_RUN_BIN_SHIFT 16u /* priority of the line, in 1/LA_BIN_STEPS of a bin, see `density` */
#define LA_RUN_BIN_MASK 0xFFu
#define LA_RUN_PEN_SHIFT 24u /* which pen draws it, see `pens` */
#define LA_RUN_PEN_MASK 0xFFu

/* Interval.flags: whether the interval is visible; what either end is (LA_END_CLIPPED, JOIN, ROUND,
 * PATH, or HIDDEN where visibility changes); between which places visibility changes there,
 * LA_CHANGE_*; and whether the interval was cut and not sampled. The ends of a cut interval are
 * exact however short it is. */
#define LA_INTERVAL_VISIBLE 1u
#define LA_INTERVAL_START_SHIFT 1u
#define LA_INTERVAL_END_SHIFT 4u
#define LA_INTERVAL_START_CHANGE_SHIFT 7u
#define LA_INTERVAL_END_CHANGE_SHIFT 9u
#define LA_INTERVAL_EXACT 0x800u
#define LA_CHANGE_MASK 3u
#define LA_CHANGE_NONE 0u
#define LA_CHANGE_WITHIN 1u /* the middles of two samples of the segment */
#define LA_CHANGE_HEAD 2u   /* the segment's start and the middle of its first sample */
#define LA_CHANGE_TAIL 3u   /* the middle of its last sample and the segment's end */

/* Arc length, positive or negative, that stands for the ends of a stroke without ends: so far away
 * that profiles have their middle value all along. */
#define LA_ENDLESS 1e9f

#endif
