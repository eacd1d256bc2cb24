/* Numbers that kernels, shaders and the host share and nobody else needs. Nothing but defines,
 * which OpenCL C, C++ and GLSL read. */
#ifndef LINEATLAS_CONSTANTS_H
#define LINEATLAS_CONSTANTS_H

/* Visibility (of 255) from which on a sample belongs to a visible interval: half of its box. Beside
 * a smooth silhouette the surface itself covers half of the box, so a quarter of the box is enough
 * there. */
#define LA_INTERVAL_SHOWN(kind) ((kind) == LA_KIND_SILHOUETTE ? 64u : 128u)
/* Steps by which a change of visibility is narrowed down, from one sample's length. */
#define LA_INTERVAL_STEPS 6

/* Strokes shorter than these, in heights of the picture, are left out. The first limit is for
 * ridges and valleys. The second is for silhouettes of undesigned surfaces, between two changes of
 * visibility, because these surfaces are rough. */
#define LA_LEAST_SHAPE 0.012f
#define LA_LEAST_ROUGH 0.005f

/* Visibility (of 255) from which on a stroke is drawn in full: a third (shaders/mark.glsl). */
#define LA_FULLY_SHOWN 85

/* Pixels per axis of a tile in which `halo` looks for lines that cross. */
#define LA_HALO_TILE 16
/* `halo` takes runs for longer than they are, by this many pixels. The first is for a run that may
 * be cut, at an end where something hides it. The second is for a run that may cut another, at both
 * ends. */
#define LA_HALO_REACH_HIDDEN 4.0f
#define LA_HALO_REACH_OVER 1.0f
/* Lines at less than this sine to each other run along each other and do not cross. */
#define LA_HALO_LEAST_SINE 0.01f
/* The largest length of a gap, over that of lines that cross at a right angle. Gaps of lines that
 * cross at a still smaller angle are shorter again: a gap that had its full length as soon as two
 * lines begin to cross would flash up. */
#define LA_HALO_STRETCH 3.0f

/* Priorities of lines that `density` tells apart, and pixels per axis of a cell of its grid. */
#define LA_DENSITY_BINS 16u
#define LA_DENSITY_CELL 8
#define LA_BIN_STEPS 16u /* steps in which a line between two bins is shared out between them */
#define LA_DENSITY_UNITS_PER_PIXEL 256.0f /* of length of line, summed as integers */
#define LA_DENSITY_TENT 81.0f             /* sum of the weights that smooth the grid */
/* The shares that kind, length and chance have in a priority. */
#define LA_PRIORITY_KIND 0.5f
#define LA_PRIORITY_LENGTH 0.3f
#define LA_PRIORITY_CHANCE 0.2f
/* Lines fade where those before them take up from 1 - this to 1 + this of the limit. */
#define LA_DENSITY_SOFTNESS 0.5f
/* The lines that are left may exceed the limit by this factor before the limit is shared out again.
 */
#define LA_DENSITY_TOLERATED 1.04f

/* A triangle that is seen nearer to edge on than this looks away: the sine of the angle between
 * surface and view, 0.0006 degrees. Otherwise rounding would decide, triangle by triangle, about a
 * wall that is seen along itself, such as that of a cylinder from above. Its outline would jump
 * between its near border and its far one, which is hidden. */
#define LA_EDGE_ON 1e-5f

/* Sine of the angle between view and surface below which ridges are not drawn, 30 degrees. The
 * surface is a mean of the triangles beside the segment and beside up to this many segments before
 * and after it on its path. */
#define LA_GRAZING 0.5f
#define LA_GRAZING_STEPS 3u

/* Cosine of the angle between view and axis, 5 degrees. At smaller angles the axis is seen end on
 * and its centre mark is drawn, at larger ones the axis. */
#define LA_END_ON 0.9961947f

/* Cosine of the sharpest turn that is joined, 150 degrees. A sharper turn gets round ends. */
#define LA_JOIN_LIMIT_COSINE -0.866025f

/* Arc lengths are summed in fixed point, so that every device gets the same result in any order of
 * summation; the sum may wrap, differences along one path stay right. */
#define LA_ARC_UNITS_PER_PIXEL 256.0f

/* Largest slope (window depth per pixel) and height (pixels) kept of a line's own face. */
#define LA_SLOPE_LIMIT 100.0f
#define LA_HEIGHT_LIMIT 100000.0f
/* In place of a height: the line runs within the face, which goes on at both sides of it. */
#define LA_BOTH_SIDES 200000.0f

/* A line's own face is recognised by its place and by its depth to within this many pixels (worth
 * of slope): the rasteriser snaps corners to a grid. */
#define LA_OWN_FACE_SNAP 0.00390625f

/* A single probe beside a fold stands this many depth texels outside it: far enough that its
 * texel's centre cannot lie on the surface that folds away. */
#define LA_FOLD_CLEARANCE 0.75f

/* A face whose depth changes by no more than this many pixel widths is recognised by depth alone:
 * beyond its own third corner other faces may lie in the same plane. */
#define LA_OWN_FACE_REACH 2.0f

/* Rounding in the depth buffer: a few units in the last place of a float just below 1. */
#define LA_DEPTH_ROUNDING 2.4e-7f

/* Rounding of nearness (1/w, or 1 - z in a parallel view), times w: that of places on the screen
 * and of planes. */
#define LA_NEARNESS_ROUNDING 4.8e-7f

/* Stand for no triangle and for no patch in tables of their numbers. */
#define LA_NO_NUMBER 0x7FFFFFFFu
#define LA_NO_PATCH -1

/* No probe touches a texel whose centre is farther than this many texels from its line: half a
 * pixel across, or for a single probe the clearance from a fold, and half a diagonal to the texel's
 * centre. */
#define LA_PROBE_REACH(depth_scale) (0.5f * (depth_scale) + 1.0f)

/* The moving average over frames: the share of the new frame, and changes of visibility (of 255)
 * that are too large to be chance, or small enough to end at once where a sample is all visible or
 * all hidden. */
#define LA_TEMPORAL_SHARE 0.22f
#define LA_TEMPORAL_LARGEST_CHANGE 170.0f
#define LA_TEMPORAL_SMALLEST_CHANGE 16.0f

/* Texels per axis of a tile of the depth pyramid. */
#define LA_TILE 16

/* How much larger a moved box is made than its size, for the rounding of what it holds. */
#define LA_BOX_ROUNDING 1e-6f

/* Segments over more tiles than this are not tested against the pyramid, because they are seldom
 * hidden as a whole. */
#define LA_MOST_TILES_TESTED 64

#endif
