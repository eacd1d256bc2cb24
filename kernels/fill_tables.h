/* Tables and scalars of `fill`. Included by kernels.h. */
#ifndef LINEATLAS_FILL_TABLES_H
#define LINEATLAS_FILL_TABLES_H

/* RGBA, 8 bits each, red lowest. */
typedef la_uint Color;

typedef struct FillColorsParameters {
    la_uint count;      /* clusters */
    la_uint has_colors; /* 0: no triangle has a colour, and the table is not read */
    la_uint lit;        /* 0: flat, and what follows the plain colour is not read */
    la_uint has_smooth; /* 0: no triangle is smooth, and the table is not read */
    la_vec4 plain;      /* of triangles that have none, 0 to 1; the last number is not read */
    la_vec4 eye; /* homogeneous: w is 1 for a point, 0 for the direction to a parallel viewer */
    la_mat4 eye_from_normal; /* normals of faces to eye space */
    la_vec4 light;           /* direction to the lamp, in eye space, of length 1 */
    float ambient;           /* light that is everywhere, 0 to 1 */
    float steps;             /* number of shades; 0: smooth */
} FillColorsParameters;

typedef struct FillPixelsParameters {
    la_ivec2 size;      /* of `pixels` */
    la_ivec2 low;       /* the first of them that is wanted */
    la_ivec2 wanted;    /* and how many are, per axis */
    la_ivec2 origin;    /* where the texels of the first of all pixels begin in `numbers` */
    la_int row;         /* texels in a row of `numbers` */
    la_int scale;       /* texels per pixel and axis, 1 to 4 */
    la_uint block;      /* pixels of a row per work-item */
    la_uint blocks;     /* a row */
    la_uint has_smooth; /* 0: no triangle is smooth, and what follows is not read */
    la_vec2 first;      /* from -1 to 1 in the picture, where the first of all texels is */
    la_vec2 step;       /* from a texel to the next */
    la_mat4 clip_from_world;
    la_vec4 eye; /* as in FillColorsParameters, what follows, too */
    la_mat4 eye_from_normal;
    la_vec4 light;
    float ambient;
    float steps;
} FillPixelsParameters;

/* Lists stay lists: */
/* clang-format off */
#define fill_colors_tables(in, out, inout, unordered) \
    in(Cluster, clusters) in(Meshlet, meshlets) in(uint, vertex_list) in(uchar, corners) \
    in(float, vertices) in(uint, seen) in(Color, colors) in(uint, smooth_corners) \
    inout(Color, shaded)
#define fill_pixels_tables(in, out, inout, unordered) \
    in(uint, numbers) in(Color, shaded) in(uint, smooth_corners) in(ContourCorner, normals) \
    in(float, vertices) inout(Color, pixels)
/* clang-format on */
#endif
