/* What the kernels of `depth` work on; included by kernels.h. */
#ifndef LINEATLAS_DEPTH_TABLES_H
#define LINEATLAS_DEPTH_TABLES_H

#include "shared/meshlet_table.h"

/* Where a cluster lies in the depth buffer. */
typedef struct ClusterPlace {
    la_int low_x, low_y, high_x, high_y; /* its texels, inclusive */
    float nearest;                       /* window depth that no part of it is before */
    la_uint key;                         /* by which it is sorted, nearest first */
} ClusterPlace;

/* The number of keys, and the key of a cluster that cannot be seen. */
#define LA_DEPTH_KEYS 1024u
#define LA_OUT_OF_VIEW LA_DEPTH_KEYS

/* Work-items that share a large triangle where each draws itself. */
#define LA_DEPTH_SHARE 256u
/* Bits of a triangle's rank within its cluster. */
#define LA_RANK_BITS 8u
/* Rank of no triangle. */
#define LA_NO_RANK 0xFFFFFFFFu

/* A texel while triangles draw themselves. Of all candidates the one that is least as a number of
 * 64 bits shows. */
typedef struct DepthTexel {
    la_uint rank;  /* of the triangle */
    la_uint order; /* its depth, negated if it is positive: as whole numbers these are in order */
} DepthTexel;

/* What a pass over the triangles finds in texels. */
#define LA_FINDS_DEPTHS 0u
#define LA_FINDS_RANKS 1u /* of the depths that are there */
#define LA_FINDS_BOTH 2u  /* at the same time, by LONG_ATOMICS */

typedef struct DepthParameters {
    la_uint count; /* clusters */
    la_mat4 clip_from_world;
    la_ivec2 whole_size; /* texels of the whole picture */
    la_ivec2 origin;     /* the first texel of `depth` in it */
    la_ivec2 depth_size; /* texels of `depth` */
    la_ivec2 covered;    /* of these the first that is wanted: that of a block */
    la_ivec2 tiles;      /* of DEPTH_TILE texels a side, from there on */
    float guard;         /* times w: what of clip space is drawn without clipping its sides */
    la_uint stride;      /* of the rows of `boxes`: at least `count` + LA_MESHLET_PADDING */
    la_uint begin, end;  /* clusters of the sorted list to draw; from 0 on depth is cleared */
    la_uint keeps_depth; /* of numbered depth 0: the numbers alone are stored */
    /* Where each triangle draws itself: */
    la_uint chunk, chunks; /* clusters that a work-item sorts, and how many do */
    la_uint numbered;      /* 1: numbers are wanted */
    la_uint finds;         /* LA_FINDS_* */
    la_int side, lanes;    /* as DEPTH_TILE and DEPTH_LANES of the device that draws */
} DepthParameters;

/* Lists stay lists: */
/* clang-format off */
#define depth_bin_tables(in, out, inout, unordered) \
    in(Cluster, clusters) out(ClusterPlace, places) out(uint, seen)
#define depth_order_tables(in, out, inout, unordered) \
    in(ClusterPlace, places) out(int, boxes) out(float, nearest) out(uint, order) out(uint, total)
#define depth_tiles_tables(in, out, inout, unordered) \
    in(int, boxes) in(float, nearest) in(uint, order) in(uint, total) \
    in(Cluster, clusters) in(Meshlet, meshlets) in(uint, vertex_list) in(uchar, corners) \
    in(float, vertices) unordered(uint, next) inout(float, depth) inout(uint, numbers) \
    inout(float, pyramid) inout(uchar, blank) inout(uint, seen)
#define depth_begin_tables(in, out, inout, unordered) out(DepthTexel, texels)
#define depth_keys_tables(in, out, inout, unordered) in(ClusterPlace, places) inout(uint, counts)
#define depth_positions_tables(in, out, inout, unordered) \
    in(ClusterPlace, places) inout(uint, counts) out(uint, positions) out(uint, order)
#define DEPTH_MODEL_TABLES(in) \
    in(Cluster, clusters) in(Meshlet, meshlets) in(uint, vertex_list) in(uchar, corners) \
    in(float, vertices) in(uint, positions)
#define depth_small_tables(in, out, inout, unordered) \
    in(ClusterPlace, places) DEPTH_MODEL_TABLES(in) inout(DepthTexel, texels) inout(uint, large_count) \
    unordered(uint, large_list)
#define depth_large_tables(in, out, inout, unordered) \
    DEPTH_MODEL_TABLES(in) inout(DepthTexel, texels) in(uint, large_count) \
    unordered(uint, large_list)
#define depth_pairs_tables(in, out, inout, unordered) depth_large_tables(in, out, inout, unordered)
#define depth_end_tables(in, out, inout, unordered) \
    in(DepthTexel, texels) in(uint, order) in(Cluster, clusters) inout(float, depth) \
    inout(uint, numbers) inout(float, pyramid) inout(uchar, blank) inout(uint, seen)
#define depth_seen_tables(in, out, inout, unordered) \
    in(ClusterPlace, places) in(float, pyramid) inout(uint, seen)
/* clang-format on */
#endif
