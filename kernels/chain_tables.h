/* Tables and scalars of `silhouette` and `chain`. Valid in OpenCL C and in C++, as segment_table.h
 * is. */
#ifndef LINEATLAS_CHAIN_TABLES_H
#define LINEATLAS_CHAIN_TABLES_H

/* The way along a chain from one silhouette, in one of its two directions: 2 n + d is silhouette n
 * taken from p to q (d = 0) or from q to p (d = 1). Together with the ways it leads to, a way knows
 * a stretch of its chain that begins with its own silhouette and gets twice as long with each
 * step. */
typedef struct ChainWay {
    la_uint next;  /* the way behind the stretch, or LA_WAY_* */
    la_uint hops;  /* silhouettes in the stretch; of a loop those of all of it */
    la_uint least; /* the least way in the stretch, which names the chain in the end */
    la_uint at;    /* silhouettes before it in the stretch */
} ChainWay;

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

typedef struct SilhouetteParameters {
    la_uint count; /* candidates */
    la_uint first; /* of them in the segment table */
} SilhouetteParameters;
#define silhouette_tables(in, out, inout, unordered)                                               \
    in(Segment, segments)in(uchar, front)out(uint, numbers)

typedef struct ChainParameters {
    la_uint count; /* candidates, of chain_link; else silhouettes, of chain_jump their ways */
    la_uint first; /* candidate in the segment table */
    la_uint step;  /* of chain_jump, from 0 */
    la_vec4 eye;   /* as in FacingParameters */
} ChainParameters;

/* Lists stay lists: */
/* clang-format off */
#define chain_link_tables(in, out, inout, unordered) \
    in(Segment, segments) in(float, vertices) in(uint, end_offsets) in(uint, ends) \
    in(uint, numbers) out(uint, chosen) out(ChainWay, ways) out(uint, positions)
#define chain_jump_tables(in, out, inout, unordered) \
    in(ChainWay, ways) out(ChainWay, longer) inout(uint, going)
#define chain_place_tables(in, out, inout, unordered) \
    in(ChainWay, ways) out(ChainPlace, places) out(uint, lengths)
#define chain_write_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, chosen) in(ChainPlace, places) in(uint, starts) \
    inout(Segment, ordered) out(uint, origins) inout(uint, positions)
/* clang-format on */

#endif
