/* What the kernels of `depth` work on; included by kernels.h. */
#ifndef LINEATLAS_DEPTH_TABLES_H
#define LINEATLAS_DEPTH_TABLES_H

#include "meshlet_table.h"

/* Where a cluster lies in the depth buffer. */
typedef struct ClusterPlace {
    la_int low_x, low_y, high_x, high_y; /* its texels, inclusive */
    float nearest;                       /* window depth that no part of it is before */
    la_uint key;                         /* by which it is sorted, nearest first */
} ClusterPlace;

/* Keys; and that of a cluster that cannot be seen. */
#define LA_DEPTH_KEYS 1024u
#define LA_OUT_OF_VIEW LA_DEPTH_KEYS

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
/* clang-format on */
#endif
