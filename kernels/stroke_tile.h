/* Tiles of the picture that kernels draw strokes in. Nothing but defines, which OpenCL C, C++ and
 * GLSL read. */
#ifndef LINEATLAS_STROKE_TILE_H
#define LINEATLAS_STROKE_TILE_H

/* Pixels a side: those of the whole picture, from its lower left corner on, whichever part of it is
 * drawn. */
#define LA_STROKE_TILE 64

/* Pixels that coverage reaches beyond a stroke's edge. */
#define LA_STROKE_FRINGE 0.5f

#endif
