/* The tables that kernels and host code share. Valid as OpenCL C 1.2 and as C++20.
 *
 * Every struct is made of 4-byte members only and has no padding, so that its layout is the same in
 * both languages and as GL vertex attributes (offsets are asserted below). */
#ifndef LINEATLAS_SEGMENT_TABLE_H
#define LINEATLAS_SEGMENT_TABLE_H

#include "flags.h"

#ifndef __OPENCL_VERSION__
#include <cstddef>
#include <cstdint>

namespace lineatlas {

using la_uint = std::uint32_t; ///< what kernels call uint
#endif

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

/** A corner that triangles of one smooth surface have in common. */
typedef struct ContourCorner {
    la_uint vertex;  /**< index into the vertex table */
    float normal[3]; /**< of length 1; 0 at a tip, as a cone has one */
} ContourCorner;

/* A segment after projection and clipping; written only where its sample count is above 0. */
typedef struct ClippedSegment {
    float p[4], q[4]; /* p', q': clipped end points in homogeneous clip space, w > 0 */
    float t0, t1;     /* clip parameters: p' lies at t0, q' at t1 of the segment; 0 and 1: whole */
    la_uint own_a, own_b; /* the two faces beside the line on the screen: descriptions (own_face in
                             project_clip.cl) or numbers (numbered_face in own_face.h) */
} ClippedSegment;

/* A piece of the list of triangles with the box around it. */
typedef struct Cluster {
    float low[3], high[3];
    la_uint first, count; /* triangles */
} Cluster;

/** A piece of one segment that is drawn, with everything that the stroke pass needs to know of it.
 * `compact` makes one run of every maximal row of samples that are at least partly visible.
 * `filter` changes the ends of runs. Runs are in the order of their segments, and along each of
 * them. Positions in pixels, origin at the lower left. */
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
    float stroke_start;    /**< arc length of the start of the stroke that the run is a part of */
    float stroke_end;      /**< and of that stroke's end */
    float start_depth;     /**< window depth of its start, 0 to 1 */
    float end_depth;       /**< and of its end */
} Run;

/** A piece of one segment that is visible all along, or hidden all along (§4.6). Intervals are what
 * is read back. `intervals` and `spans` write them in the order of the segments and along each of
 * them. Positions in pixels, origin at the lower left. */
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

/* The gaps that nearer lines leave in a run, see `halo`: arc lengths along the run's path,
 * ascending, perhaps overlapping. Unused cuts have from = to = 0. */
#define LA_MOST_CUTS 8
typedef struct RunCuts {
    float from[LA_MOST_CUTS], to[LA_MOST_CUTS];
} RunCuts;

/* How much the stroke pass draws, in the layout of glDrawArraysIndirect, and what the host learns
 * of a frame. `compact` writes it. The host reads it only after the frame's kernels are done. */
typedef struct FrameRecord {
    la_uint points[4];     /* {runs, 1, 0, 0}: one point per run for the geometry shader */
    la_uint sample_total;  /* samples the frame needs; 0xFFFFFFFF: more than can be counted */
    la_uint run_total;     /* runs the frame needs; above the table's capacity nothing is drawn */
    la_uint raw_run_total; /* of `filter`: run_total of the runs that it was to filter */
    la_uint unused;
} FrameRecord;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(Segment) == 32 && sizeof(ClippedSegment) == 48);
static_assert(sizeof(Cluster) == 32 && sizeof(Run) == 80 && sizeof(FrameRecord) == 32);
static_assert(sizeof(RunCuts) == 64);
static_assert(sizeof(Interval) == 76);
static_assert(offsetof(ClippedSegment, t0) == 32 && offsetof(Run, start_arc) == 32);
} // namespace lineatlas
#endif

#endif
