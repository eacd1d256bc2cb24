/* The tables that kernels, shaders and host code share. Valid as OpenCL C 1.2 and as C++20.
 *
 * Every struct is made of 4-byte members only and has no padding, so that its layout is the same in
 * both languages and as GL vertex attributes (offsets are asserted below). */
#ifndef LINEATLAS_SEGMENT_TABLE_H
#define LINEATLAS_SEGMENT_TABLE_H

#ifdef __OPENCL_VERSION__
typedef uint la_uint;
#else
#include <cstddef>
#include <cstdint>

namespace lineatlas {

using la_uint = std::uint32_t; ///< what kernels call uint
#endif

/* Line kinds; bit 1 << kind selects one in a kind mask. */
#define LA_KIND_CREASE 0u
#define LA_KIND_BOUNDARY 1u
#define LA_KIND_MATERIAL 2u
#define LA_KIND_SILHOUETTE 3u
#define LA_KIND_FILE 4u
#define LA_KIND_COUNT 5u

/* Segment.tag: the kind in the low bits, then flags. */
#define LA_TAG_KIND_MASK 0x7u
#define LA_TAG_CLOSED 0x8u /* the path is a loop: its last segment continues in its first */
#define LA_TAG_LONE 0x10u  /* touches no other segment: dropped when sub-pixel (§4.1) */

/* Segment.face_a, face_b: a triangle index, or LA_NO_FACE. LA_FACE_FLIPPED in face_b says that its
 * winding disagrees with face_a's, so that its facing must be negated before the two are compared.
 */
#define LA_NO_FACE 0xFFFFFFFFu
#define LA_FACE_FLIPPED 0x80000000u
#define LA_FACE_INDEX 0x7FFFFFFFu

/** One candidate segment (§4.1, Fig. 7 step 1). Segments of a path are neighbours in the table. */
typedef struct Segment {
    la_uint p;          /**< its start: index into the vertex table */
    la_uint q;          /**< its end: index into the vertex table */
    la_uint face_a;     /**< a triangle beside it, or LA_NO_FACE */
    la_uint face_b;     /**< the other one, perhaps with LA_FACE_FLIPPED */
    la_uint from_start; /**< segments of the same path before this one */
    la_uint to_end;     /**< segments of the same path after this one */
    la_uint path;       /**< index of the path */
    la_uint tag;        /**< kind and flags, LA_TAG_* */
} Segment;

/* A segment after projection and clipping; written only where its sample count is above 0. */
typedef struct ClippedSegment {
    float p[4], q[4]; /* p', q': clipped end points in homogeneous clip space, w > 0 */
    float t0, t1;     /* clip parameters: p' lies at t0, q' at t1 of the segment; 0 and 1: whole */
    la_uint own_a,
        own_b; /* the two faces beside the line on the screen, see own_face in project_clip.cl */
} ClippedSegment;

/* A piece of the list of triangles with the box around it. */
typedef struct Cluster {
    float low[3], high[3];
    la_uint first, count; /* triangles */
} Cluster;

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
#define LA_RUN_KIND_SHIFT 12u
#define LA_RUN_SOLID 0x8000u /* visible all along: the atlas has no samples of it */
#define LA_RUN_BIN_SHIFT 16u /* priority of the line, in 1/LA_BIN_STEPS of a bin, see `density` */
#define LA_RUN_BIN_MASK 0xFFu

/** A piece of one segment that is drawn; everything that the stroke pass and the readback need to
 * know of it. `compact` makes one of every maximal row of samples that are at least partly visible,
 * `filter` changes their ends. Runs are in the order of their segments, and along each of them.
 * Positions in pixels, origin at the lower left. */
typedef struct Run {
    float start[2];        /**< window position of its start */
    float end[2];          /**< and of its end */
    float start_corner[2]; /**< at a join: from the spine to the left corner on the bisector, for
                                half-width 1; else 0 */
    float end_corner[2];   /**< the same at its end */
    float start_arc;       /**< arc length along the path, 0 in its middle, in pixels */
    float end_arc;         /**< the same of its end */
    float start_sample;    /**< its start counted in samples of the segment: 0 to l, or beyond where
                                a stroke overshoots its path */
    float end_sample;      /**< the same of its end */
    la_uint address;       /**< of the segment's first sample in the atlas */
    la_uint samples;       /**< l, the segment's sample count */
    la_uint flags;         /**< ends and kind, LA_RUN_* */
    la_uint segment;       /**< index into the segment table */
    float stroke_start;    /**< arc length of the start of the stroke that it is a part of */
    float stroke_end;      /**< and of that stroke's end */
    float start_depth;     /**< window depth of its start, 0 to 1 */
    float end_depth;       /**< and of its end */
} Run;

/** A piece of one segment that is visible all along, or hidden all along (§4.6): what the readback
 * gives. Written by `intervals`, in the order of the segments and along each of them. Positions in
 * pixels, origin at the lower left. */
typedef struct Interval {
    float start[2];       /**< window position of its start */
    float end[2];         /**< and of its end */
    float start_depth;    /**< window depth of its start, 0 to 1 */
    float end_depth;      /**< and of its end */
    float start_world[3]; /**< the point of the model that is seen at its start */
    float end_world[3];   /**< and at its end */
    float start_arc;      /**< arc length along the path, 0 in its middle, in pixels */
    float end_arc;        /**< the same of its end */
    float start_sample;   /**< its start counted in samples of the segment */
    float end_sample;     /**< and its end */
    float alpha;          /**< mean visibility of its samples, 0 to 1 */
    la_uint segment;      /**< index into the segment table */
    la_uint flags;        /**< LA_INTERVAL_* */
} Interval;

/* Interval.flags: whether it is visible, what either end is (LA_END_CLIPPED, JOIN, ROUND, HIDDEN:
 * visibility changes, or PATH), and between what visibility changes there. */
#define LA_INTERVAL_VISIBLE 1u
#define LA_INTERVAL_START_SHIFT 1u
#define LA_INTERVAL_END_SHIFT 4u
#define LA_INTERVAL_START_CHANGE_SHIFT 7u
#define LA_INTERVAL_END_CHANGE_SHIFT 9u
#define LA_CHANGE_MASK 3u
#define LA_CHANGE_NONE 0u
#define LA_CHANGE_WITHIN 1u /* the middles of two samples of the segment */
#define LA_CHANGE_HEAD 2u   /* the segment's start and the middle of its first sample */
#define LA_CHANGE_TAIL 3u   /* the middle of its last sample and the segment's end */

/* Visibility (of 255) from which on a sample belongs to a visible interval: half of its box. Beside
 * a smooth silhouette half of the box is the surface itself, so half of it is all there is to see.
 */
#define LA_INTERVAL_SHOWN(kind) ((kind) == LA_KIND_SILHOUETTE ? 64u : 128u)
/* Steps by which a change of visibility is narrowed down, from one sample's length. */
#define LA_INTERVAL_STEPS 6

/* Where nearer lines leave a gap in a run: arc lengths along its path, ascending, perhaps
 * overlapping; unused ones have from = to = 0. See `halo`. */
#define LA_MOST_CUTS 8
typedef struct RunCuts {
    float from[LA_MOST_CUTS], to[LA_MOST_CUTS];
} RunCuts;

/* Arc length, either way, of the ends of a stroke that has none: so far away that profiles have
 * their middle value all along. */
#define LA_ENDLESS 1e9f

/* Visibility (of 255) from which on a stroke is drawn in full: a third (shaders/mark.glsl). */
#define LA_FULLY_SHOWN 85

/* Pixels per axis of a tile in which `halo` looks for lines that cross. */
#define LA_HALO_TILE 16
/* A visible run is longer by this for `halo`, in pixels: one that ends behind the line that hides
 * it, and any that crosses another near its end. */
#define LA_HALO_REACH_HIDDEN 4.0f
#define LA_HALO_REACH_OVER 1.0f
/* Lines at less than this sine to each other run along each other and do not cross. */
#define LA_HALO_LEAST_SINE 0.01f
/* A gap is at most this much longer than that of a line that crosses at a right angle. Where they
 * cross at a smaller angle than that it is shorter again: one that came at its full length when two
 * lines begin to cross would flash up. */
#define LA_HALO_STRETCH 3.0f

/* Priorities of lines that `density` tells apart, and pixels per axis of a cell of its grid. */
#define LA_DENSITY_BINS 16u
#define LA_DENSITY_CELL 8
#define LA_BIN_STEPS 16u /* a line between two bins is shared out between them in such steps */
#define LA_DENSITY_UNITS_PER_PIXEL 256.0f /* of length of line, summed as integers */
#define LA_DENSITY_TENT 81.0f             /* sum of the weights that smooth the grid */
/* What kind, length and chance contribute to a priority. */
#define LA_PRIORITY_KIND 0.5f
#define LA_PRIORITY_LENGTH 0.3f
#define LA_PRIORITY_CHANCE 0.2f
/* Lines fade where those before them take up from 1 - this to 1 + this of the limit. */
#define LA_DENSITY_SOFTNESS 0.5f
/* What is left of lines may exceed the limit by this factor before it is shared out again. */
#define LA_DENSITY_TOLERATED 1.04f

/* What the stroke pass draws, in the layouts of glDrawArraysIndirect, and what the host learns of a
 * frame. Written by `compact`; the host reads it only after the frame's kernels are done. */
typedef struct FrameRecord {
    la_uint points[4];     /* {runs, 1, 0, 0}: one point per run for the geometry shader */
    la_uint quads[4];      /* {4, runs, 0, 0}: one instanced strip per run for the vertex shader */
    la_uint sample_total;  /* samples the frame needs; 0xFFFFFFFF: more than can be counted */
    la_uint run_total;     /* runs the frame needs; above the table's capacity nothing is drawn */
    la_uint raw_run_total; /* of `filter`: the runs it was to filter, as run_total */
    la_uint unused;
} FrameRecord;

/* Cosine of the sharpest turn that is joined; a sharper one gets round ends. 150 degrees. */
#define LA_JOIN_LIMIT_COSINE -0.866025f

/* Arc lengths are summed in fixed point, so that every device gets the same result in any order of
 * summation; the sum may wrap, differences along one path stay right. */
#define LA_ARC_UNITS_PER_PIXEL 256.0f

/* Largest slope (window depth per pixel) and height (pixels) kept of a line's own face. */
#define LA_SLOPE_LIMIT 100.0f
#define LA_HEIGHT_LIMIT 100000.0f

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

/* No probe touches a texel whose centre is farther than this many texels from its line: half a
 * pixel across, or for a single probe the clearance from a fold, and half a diagonal to the texel's
 * centre. */
#define LA_PROBE_REACH(depth_scale) (0.5f * (depth_scale) + 1.0f)

/* The moving average over frames: the share of the new frame in it, and changes of visibility (of
 * 255) that are too large to be chance, or too small to bother at either extreme. */
#define LA_TEMPORAL_SHARE 0.27f
#define LA_TEMPORAL_LARGEST_CHANGE 105.0f
#define LA_TEMPORAL_SMALLEST_CHANGE 16.0f

/* Texels per axis of a tile of the depth pyramid. */
#define LA_TILE 16

/* How much larger a moved box is than it must be: rounding of what is moved. */
#define LA_BOX_ROUNDING 1e-6f

/* Segments over more tiles than this are not tested against the pyramid: they are seldom hidden
 * whole. */
#define LA_MOST_TILES_TESTED 64

#ifndef __OPENCL_VERSION__
static_assert(sizeof(Segment) == 32 && sizeof(ClippedSegment) == 48);
static_assert(sizeof(Cluster) == 32 && sizeof(Run) == 80 && sizeof(FrameRecord) == 48);
static_assert(sizeof(RunCuts) == 64);
static_assert(sizeof(Interval) == 76);
static_assert(offsetof(ClippedSegment, t0) == 32 && offsetof(Run, start_arc) == 32);
} // namespace lineatlas
#endif

#endif
