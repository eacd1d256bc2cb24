/* Tables and scalars of `silhouette` and `chain`. Valid in OpenCL C and in C++, as segment_table.h
 * is. */
#ifndef LINEATLAS_CHAIN_TABLES_H
#define LINEATLAS_CHAIN_TABLES_H

/* The way along a chain from one silhouette, in one of its two directions: 2 n + d is silhouette n
 * taken from p to q (d = 0) or from q to p (d = 1). A way knows a stretch of its chain that begins
 * with its own silhouette. With each step of chain_jump the stretch gets LA_WAY_GROWTH times as
 * long. */
typedef struct ChainWay {
    la_uint next;  /* the way behind the stretch, or LA_WAY_* */
    la_uint hops;  /* silhouettes in the stretch; of a loop, in the whole loop */
    la_uint least; /* the rank of the least way in the stretch, which names the chain in the end */
    la_uint at;    /* silhouettes before that least way in the stretch */
} ChainWay;

/* By how much a stretch grows with each step of chain_jump. */
#define LA_WAY_GROWTH 4u

/* Flag in ChainWay.least: the frame before did not have the silhouette. */
#define LA_RANK_NEW 0x80000000u

/* ChainWay.next: */
#define LA_WAY_ENDS 0xFFFFFFFFu   /* the stretch reaches to the chain's end */
#define LA_WAY_CLOSES 0xFFFFFFFEu /* the chain is a loop, and all of it is known */

/* Where a silhouette stands in its chain. */
typedef struct ChainPlace {
    la_uint leader;        /* the silhouette that names the chain: its least */
    la_uint before, after; /* silhouettes of the chain on either side */
    la_uint flags;         /* LA_PLACE_* */
} ChainPlace;

#define LA_PLACE_REVERSED 1u /* runs from its q to its p */
#define LA_PLACE_CLOSED 2u   /* the chain is a loop */

#define LA_NO_SURFACE 0xFFFFFFFFu /* a triangle without contours is of this surface */

/* How far places of contours are lifted off the surface, as a share of how far corners of their
 * triangle lie off the tangents of its surface. An arc rises over its chord by a quarter. */
#define LA_CONTOUR_LIFT 0.5f
/* On undesigned surfaces a closed contour through no more triangles than this is noise. */
#define LA_LEAST_LOOP 12u

/* The triangles beside an edge that contours may cross, whatever surface they are of, as in
 * Segment. */
typedef struct ContourEdge {
    la_uint face_a, face_b;
} ContourEdge;

/* A triangle that contours may run through: its edges from corner to corner, and the next such
 * triangle across each edge. LA_CONTOUR_TURNED marks an edge that runs the other way. LA_NO_FACE
 * across an edge: the surface ends there, and a line goes on. The corners are in a table of their
 * own. */
typedef struct ContourFace {
    la_uint edges[3], across[3];
} ContourFace;

/* Where a contour runs through such a triangle. As seen from outside, the side that shows its front
 * is on the left; on a mirrored object it is on the right. */
typedef struct ContourCrossing {
    la_uint p, q;          /* vertices on the surface; the next vertex is each one lifted off it */
    la_uint before, after; /* the silhouettes that end at p and begin at q, or LA_NO_SILHOUETTE */
    la_uint underside;     /* 1: it is seen from the back of its surface */
} ContourCrossing;

#define LA_NO_SILHOUETTE 0xFFFFFFFFu

typedef struct ContourParameters {
    la_uint count;        /* of contour_facing corners, of contour_cross triangles, of
                             contour_places silhouettes */
    la_uint first_vertex; /* of places: four for each silhouette */
    la_uint first_number; /* of contours */
    la_uint contours;     /* the first candidate that is a contour */
    la_uint first;        /* of contour_places: in the segment table, of candidates */
    la_uint on_surface;   /* of contour_places: 1: contours are drawn on the surface, not where they
                             are lifted */
    la_vec4 eye;          /* as in FacingParameters */
} ContourParameters;

/* Candidates by edges of the mesh come first, then those that contours stand for, then contours.
 * Those in the middle are never silhouettes, and `numbers` leaves them out. */
typedef struct SilhouetteParameters {
    la_uint count; /* candidates before those in the middle; for silhouette_list all candidates */
    la_uint first; /* candidate in the segment table */
    la_uint replaced; /* the first in the middle; `count` where there are no contours */
    la_uint contours; /* the first contour; without contours a number that no candidate has */
    la_uint capacity; /* of silhouette_list: silhouettes that have room, at most `count` */
} SilhouetteParameters;

typedef struct ChainParameters {
    la_uint count;    /* silhouettes that there is room for; for chain_jump their ways */
    la_uint first;    /* candidate in the segment table */
    la_uint step;     /* of chain_jump, from 0 */
    la_vec4 eye;      /* as in FacingParameters */
    la_uint contours; /* as in SilhouetteParameters */
    la_uint lifted;   /* 1: contours are drawn lifted */
    la_uint follows;  /* 1: chains keep the names and directions of the frame before */
    la_uint outside;  /* 1: the eye looks at all parts from without */
} ChainParameters;

/* Lists stay lists: */
/* clang-format off */
#define contour_normals_tables(in, out, inout, unordered) \
    in(float, vertices) in(uint, triangles) in(uint, offsets) in(uint, places) \
    inout(ContourCorner, corners)
#define contour_turn_tables(in, out, inout, unordered) \
    in(ContourCorner, rest) in(uint, objects) in(float, turns) out(ContourCorner, corners)
#define contour_facing_tables(in, out, inout, unordered) \
    in(ContourCorner, corners) in(float, vertices) out(float, facing)
#define contour_cross_tables(in, out, inout, unordered) \
    in(uint, face_corners) in(float, facing) out(uint, numbers)
#define contour_places_tables(in, out, inout, unordered) \
    in(uint, chosen) in(uint, numbers) in(uint, face_corners) in(float, facing) \
    in(ContourFace, faces) in(ContourCorner, corners) in(ContourEdge, edges) in(uint, triangles) \
    in(Segment, segments) in(uchar, front) inout(float, vertices) out(ContourCrossing, crossings)
#define silhouette_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uchar, front) out(uint, numbers)
#define silhouette_list_tables(in, out, inout, unordered) \
    in(uint, numbers) out(uint, chosen) out(uint, positions) out(uint, total)
#define chain_link_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, chosen) in(ContourCrossing, crossings) in(float, vertices) \
    in(uint, end_offsets) in(uint, ends) in(uint, numbers) in(uint, positions_before) \
    out(ChainWay, ways)
#define chain_jump_tables(in, out, inout, unordered) \
    in(ChainWay, ways) out(ChainWay, longer) inout(uint, going)
#define chain_place_tables(in, out, inout, unordered) \
    in(ChainWay, ways) out(ChainPlace, places) out(uint, lengths)
#define chain_write_tables(in, out, inout, unordered) \
    in(Segment, segments) in(ContourCrossing, crossings) in(uint, chosen) in(ChainPlace, places) \
    in(uint, starts) \
    inout(Segment, ordered) out(uint, origins) inout(uint, positions)
/* clang-format on */

#endif
