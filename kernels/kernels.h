/* Every kernel with its scalars and its tables. Compiling, launching, comparing, profiling and
 * checking all read this one list.
 *
 * A kernel's scalars are one struct, passed by value. Its tables follow as NAME_tables(in, out,
 * inout, unordered): `in` is only read, `out` only written, `inout` both; the elements of an
 * `unordered` one may come in any order. Valid in OpenCL C and in C++ (host/compute/kernels.hpp),
 * where la_vec2 and the like are GLM's. */
#ifndef LINEATLAS_KERNELS_H
#define LINEATLAS_KERNELS_H

#include "shared/constants.h"
#include "shared/language.h"

#include "segment_table.h" /* in the words of language.h */
#include "style_numbers.h"

/* Lists stay lists: */
/* clang-format off */

/* For kernels with one work-item per element of a table. */
typedef struct CountParameters {
    la_uint count;
} CountParameters;

/* The tables of a frame that most stages read. */
#define FRAME_TABLES(in) \
    in(Segment, segments) in(ClippedSegment, clipped) in(uint, offsets) in(uint, arcs)

#define transform_tables(in, out, inout, unordered) \
    in(float, rest) in(uint, objects) in(float, matrices) out(float, vertices) out(float, drawn)
#define transform_boxes_tables(in, out, inout, unordered) \
    in(Cluster, rest) in(uint, objects) in(float, matrices) out(Cluster, clusters)
#define transform_bounds_tables(in, out, inout, unordered) \
    in(float, vertices) in(uint, triangles) inout(Cluster, clusters)
#define transform_forget_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, objects) in(uchar, jumped) inout(uint, ranges)

typedef struct PyramidParameters {
    la_ivec2 depth_size; /* texels */
    la_ivec2 tile_count;
} PyramidParameters;
#define pyramid_tables(in, out, inout, unordered) in(float, depth) out(float, tiles)

typedef struct CullParameters {
    la_uint count;
    la_mat4 clip_from_world;
    la_ivec2 depth_size; /* texels */
    la_ivec2 tile_count;
} CullParameters;
#define cull_tables(in, out, inout, unordered) \
    in(Cluster, clusters) in(float, tiles) out(uint, visible)

typedef struct FacingParameters {
    la_uint count;
    la_vec4 eye; /* homogeneous: w is 1 for a point, 0 for the direction to a parallel viewer */
} FacingParameters;
#define facing_tables(in, out, inout, unordered) \
    in(float, vertices) in(uint, triangles) out(uchar, front)

/* A batch: neighbours in the table of segments, or of triangles. They are tested together before any
 * of them is tested alone. */
#define LA_BATCH 64u
typedef struct Batch {
    float low[3], high[3]; /* the box around them; for segments also around the faces beside them */
    la_uint joined[2];     /* bit i % 32 of i / 32: the path of segment i goes on in another batch */
    float widest;          /* no triangle of the batch is wider than this; 0 for segments */
} Batch;
/* What is known of a batch in a frame: */
#define LA_BATCH_SEEN 0u    /* nothing: each of it is to be looked at */
#define LA_BATCH_OUTSIDE 1u /* all of it lies outside the frustum */
#define LA_BATCH_HIDDEN 2u  /* all of it is hidden */

/* ProjectClipParameters.hidden: segments that the pyramid shows hidden. */
#define LA_HIDDEN_SAMPLED 0u /* get samples like all others: there is no pyramid */
#define LA_HIDDEN_DROPPED 1u /* are left out, except for what their neighbours need */
#define LA_HIDDEN_CLIPPED 2u /* are clipped though they get no samples */

typedef struct ProjectClipParameters {
    la_uint count;
    la_mat4 clip_from_world, world_from_clip;
    la_vec2 viewport;  /* pixels */
    float step;        /* k: pixels per sample, above 0 */
    la_uint kind_mask; /* kinds to draw, bit 1 << kind */
    la_uint hidden;    /* LA_HIDDEN_* */
    la_ivec2 tile_count;
    float depth_scale; /* depth texels per pixel */
    float tolerance;   /* window depth that may stand before a line, times w */
    la_uint numbered;  /* 1: own faces are numbers, for probes that know surfaces */
    la_uint batched;   /* number of first segments whose batches have states */
    float overhang;    /* pixels by which centre lines are longer at either end */
} ProjectClipParameters;
#define project_clip_boxes_tables(in, out, inout, unordered) \
    in(Segment, segments) in(float, vertices) in(uint, triangles) out(Batch, batches)
#define project_clip_batches_tables(in, out, inout, unordered) \
    in(Batch, batches) in(float, tiles) out(uchar, states)
#define project_clip_tables(in, out, inout, unordered) \
    in(Batch, batches) in(uchar, states) \
    in(Segment, segments) in(float, vertices) in(uint, triangles) in(uchar, front) \
    in(float, tiles) in(uint, numbers) out(ClippedSegment, clipped) out(uint, counts) \
    out(uint, arcs)

typedef struct ScanParameters {
    la_uint n;       /* values; tiles of `scan_tiles_sums` */
    la_uint chunk;   /* values per work-item, of chunks */
    la_uint scanned; /* 1: `scan_tiles_sums` has scanned the sums of tiles */
} ScanParameters;
#define scan_chunks_reduce_tables(in, out, inout, unordered) in(uint, values) out(uint, sums)
#define scan_chunks_apply_tables(in, out, inout, unordered) inout(uint, values) in(uint, sums)
#define scan_tiles_reduce_tables(in, out, inout, unordered) in(uint, values) out(uint, sums)
#define scan_tiles_sums_tables(in, out, inout, unordered) inout(uint, sums)
#define scan_tiles_apply_tables(in, out, inout, unordered) inout(uint, values) in(uint, sums)
#define scan_list_tables(in, out, inout, unordered) in(uint, values) out(uint, list)

/* What a probe must know of a view to judge surfaces by their planes, see spine.h. */
typedef struct SurfaceParameters {
    la_uint known;    /* 0: nothing is known but depth, and the tables are not read */
    la_uint parallel; /* 1: of a parallel view */
    float bend;       /* nearness by which a line's own patch may stand before it, times w */
} SurfaceParameters;
#define SURFACE_TABLES(in) in(uint, numbers) in(float, planes) in(uint, patches)

typedef struct PlanesParameters {
    la_uint count; /* clusters */
    /* Maps place x and y on the screen (-1 to 1), 1 and nearness to a homogeneous point of the
     * world. */
    la_mat4 world_from_screen;
    float contact;       /* a point nearer to a plane than this touches it; world units */
    la_uint only_seen;   /* 1: only of clusters that `seen` names; the others keep what they had */
} PlanesParameters;
#define planes_tables(in, out, inout, unordered) \
    in(Cluster, clusters) in(Meshlet, meshlets) in(uint, vertex_list) in(uchar, corners) \
    in(float, vertices) in(uint, seen) inout(float, planes)

typedef struct AtlasParameters {
    la_uint count; /* segments */
    la_ivec2 depth_size;
    la_vec2 viewport;
    float depth_scale, tolerance; /* as in ProjectClipParameters */
    SurfaceParameters surfaces;
    la_uint capacity; /* samples that the atlas has room for */
    la_uint block;   /* samples per work-item */
    la_ivec2 origin; /* TILED: the first texel of `depth` in the whole */
    la_ivec4 core;   /* TILED: samples in these texels, from xy up to, without, zw, are computed */
} AtlasParameters;
#define atlas_tables(in, out, inout, unordered) \
    in(ClippedSegment, clipped) in(uint, offsets) in(float, depth) SURFACE_TABLES(in) \
    out(uchar, alpha)

/* TemporalParameters.history: what the frame before is good for. */
#define LA_HISTORY_NONE 0u   /* only remember the ranges */
#define LA_HISTORY_CAMERA 1u /* the camera alone has moved since */
#define LA_HISTORY_SCENE 2u  /* objects have moved too: what is hidden now may be so for good */

typedef struct TemporalParameters {
    la_uint count; /* segments */
    la_uint capacity; /* samples that the atlas has room for */
    la_uint block;   /* segments per work-item */
    la_uint history; /* LA_HISTORY_* */
    la_uint first;   /* the first segment that `chain` has placed in this frame */
} TemporalParameters;
#define temporal_tables(in, out, inout, unordered) \
    in(ClippedSegment, clipped) in(uint, offsets) in(uint, offsets_before) in(uchar, before) \
    in(uint, origins) in(uint, positions_before) inout(uint, ranges) inout(uchar, alpha)

typedef struct CompactParameters {
    la_uint count; /* segments */
    la_uint capacity; /* samples that the atlas has room for */
    la_vec2 viewport;
    float half_width; /* of the stroke, in pixels: decides where a join has room */
    la_uint hidden;   /* 1: runs of hidden samples instead of visible ones */
    la_uint block;    /* segments per work-item */
    la_uint blocks;
    la_uint run_capacity;
} CompactParameters;
#define compact_count_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(uchar, alpha) out(uint, counts)
#define compact_write_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(uchar, alpha) in(uint, block_offsets) out(Run, runs) \
    out(FrameRecord, record)

typedef struct FilterParameters {
    la_uint capacity; /* samples that the atlas has room for */
    la_vec2 viewport;
    float half_width; /* as in CompactParameters */
    StrokeFilter filter;
    la_uint use_cuts; /* 0: `cuts` is not read */
    la_uint run_capacity, filtered_capacity;
} FilterParameters;
#define filter_count_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(uchar, alpha) in(Run, runs) in(FrameRecord, record) in(RunCuts, cuts) \
    out(uint, counts)
#define filter_write_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(uchar, alpha) in(Run, runs) in(FrameRecord, record) in(RunCuts, cuts) \
    in(uint, run_offsets) out(Run, filtered) out(FrameRecord, filtered_record)
#define filter_show_tables(in, out, inout, unordered) \
    in(Run, filtered) in(FrameRecord, filtered_record) inout(uchar, alpha)
#define filter_show_ends_tables(in, out, inout, unordered) \
    in(Segment, segments) in(Run, runs) in(FrameRecord, record) inout(uchar, alpha)

typedef struct HaloParameters {
    la_ivec2 tiles;
    float width;     /* from the middle of the nearer stroke to the end of the gap, pixels */
    float tolerance; /* as in ProjectClipParameters; a line is nearer if it is so by more than this */
    la_uint total;   /* entries of all lists */
} HaloParameters;
#define halo_count_tables(in, out, inout, unordered) \
    in(Run, runs) in(FrameRecord, record) inout(uint, counts)
#define halo_fill_tables(in, out, inout, unordered) \
    in(Run, runs) in(FrameRecord, record) inout(uint, ends) unordered(float, memory)
#define halo_cut_tables(in, out, inout, unordered) \
    in(Segment, segments) in(ClippedSegment, clipped) in(Run, runs) in(FrameRecord, record) \
    in(uint, ends) unordered(float, memory) out(RunCuts, cuts)

typedef struct DensityParameters {
    la_ivec2 cells;
    float cell, per_cell; /* pixels per axis of each, and its inverse */
    Density density;
    la_vec4 focus;   /* centre x and y, radius and falloff in pixels; falloff 0: no focus */
    float far_limit; /* factor of the limit far from the focus */
    la_uint again;   /* 1: where the first weights left too much */
    la_uint hidden;  /* 1: runs are of hidden lines, drawn where samples are not visible */
} DensityParameters;
#define density_lines_tables(in, out, inout, unordered) \
    in(Segment, segments) in(uint, arcs) in(uchar, alpha) in(FrameRecord, record) \
    inout(Run, runs) inout(uint, grid)
#define density_smooth_tables(in, out, inout, unordered) in(uint, grid) out(uint, smooth)
#define density_weights_tables(in, out, inout, unordered) \
    in(uint, grid) in(uint, smooth) in(float, excess) inout(float, weights) inout(float, drawn)
#define density_excess_tables(in, out, inout, unordered) in(float, drawn) out(float, excess)

typedef struct IntervalsParameters {
    la_uint count; /* segments */
    la_uint capacity; /* samples that the atlas has room for */
    la_vec2 viewport;
    la_uint wanted; /* bit 0 visible ones, bit 1 hidden ones */
    la_uint block;  /* segments per work-item */
    la_uint blocks;
    la_uint interval_capacity;
    la_ivec2 depth_size;
    float depth_scale, tolerance; /* as in ProjectClipParameters */
    SurfaceParameters surfaces;
} IntervalsParameters;
#define intervals_count_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(uchar, alpha) out(uint, counts)
#define intervals_write_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(uchar, alpha) in(uint, block_offsets) out(Interval, intervals) \
    out(uint, interval_total)
#define intervals_refine_tables(in, out, inout, unordered) \
    FRAME_TABLES(in) in(float, vertices) in(float, depth) SURFACE_TABLES(in) \
    inout(Interval, intervals) in(uint, interval_total)

#include "carry_tables.h"
#include "chain_tables.h"
#include "depth_tables.h"
#include "exact_tables.h"
#include "fill_tables.h"
#include "stroke_tables.h"

/* All of them, in the order of a frame: the stage that the kernel belongs to and that names its
 * file, the kernel, and the type of its parameters. `of_sums`: one for each SCAN_SATURATE;
 * `of_tiles`: those of them that need local memory and barriers; `of_numbers`: without NUMBERED and
 * with it; `of_probes`: one for each PROBES_PER_AXIS, with TILED and without. */
#define LA_KERNELS(kernel, of_sums, of_tiles, of_numbers, of_probes) \
    kernel(transform, transform_bounds, CountParameters) \
    kernel(transform, transform, CountParameters) \
    kernel(transform, transform_boxes, CountParameters) \
    kernel(contour, contour_normals, CountParameters) \
    kernel(contour, contour_turn, CountParameters) \
    kernel(depth, depth_bin, DepthParameters) \
    kernel(depth, depth_order, DepthParameters) \
    of_numbers(depth, depth_tiles, DepthParameters) \
    kernel(depth, depth_begin, DepthParameters) \
    kernel(depth, depth_keys, DepthParameters) \
    kernel(depth, depth_positions, DepthParameters) \
    kernel(depth, depth_small, DepthParameters) \
    kernel(depth, depth_large, DepthParameters) \
    kernel(depth, depth_pairs, DepthParameters) \
    kernel(depth, depth_end, DepthParameters) \
    kernel(depth, depth_seen, DepthParameters) \
    kernel(planes, planes, PlanesParameters) \
    kernel(pyramid, pyramid, PyramidParameters) \
    kernel(cull, cull, CullParameters) \
    kernel(facing, facing, FacingParameters) \
    kernel(contour, contour_facing, ContourParameters) \
    kernel(contour, contour_cross, ContourParameters) \
    kernel(silhouette, silhouette, SilhouetteParameters) \
    kernel(silhouette, silhouette_list, SilhouetteParameters) \
    kernel(contour, contour_places, ContourParameters) \
    kernel(chain, chain_link, ChainParameters) \
    kernel(chain, chain_jump, ChainParameters) \
    kernel(chain, chain_place, ChainParameters) \
    kernel(chain, chain_write, ChainParameters) \
    kernel(project_clip, project_clip_boxes, CountParameters) \
    kernel(project_clip, project_clip_batches, ProjectClipParameters) \
    kernel(project_clip, project_clip, ProjectClipParameters) \
    of_sums(scan, scan_chunks_reduce, ScanParameters) \
    of_sums(scan, scan_chunks_apply, ScanParameters) \
    of_tiles(scan, scan_tiles_reduce, ScanParameters) \
    of_tiles(scan, scan_tiles_sums, ScanParameters) \
    of_tiles(scan, scan_tiles_apply, ScanParameters) \
    of_sums(scan, scan_list, CountParameters) \
    kernel(carry, carry_recall, CarryParameters) \
    kernel(carry, carry_keep, CarryParameters) \
    kernel(carry, carry_breaks, CarryParameters) \
    kernel(carry, carry_pieces, CarryParameters) \
    kernel(carry, carry_settle, CarryParameters) \
    kernel(carry, carry_place, CarryParameters) \
    of_probes(atlas, atlas, AtlasParameters) \
    kernel(transform, transform_forget, CountParameters) \
    kernel(temporal, temporal, TemporalParameters) \
    kernel(intervals, intervals_count, IntervalsParameters) \
    kernel(intervals, intervals_write, IntervalsParameters) \
    kernel(intervals, intervals_refine, IntervalsParameters) \
    kernel(surfaces, surfaces_vertices, ExactParameters) \
    kernel(surfaces, surfaces_faces, ExactParameters) \
    kernel(surfaces, surfaces_boxes, CountParameters) \
    kernel(surfaces, surfaces_occluders, ExactParameters) \
    kernel(surfaces, surfaces_batches, ExactParameters) \
    kernel(tile_lists, tile_lists_count, ExactParameters) \
    kernel(tile_lists, tile_lists_groups, ExactParameters) \
    kernel(tile_lists, tile_lists_fill, ExactParameters) \
    kernel(tile_lists, tile_lists_arrange, ExactParameters) \
    kernel(tile_lists, tile_lists_keys, ExactParameters) \
    kernel(tile_lists, tile_lists_place, ExactParameters) \
    kernel(tile_lists, tile_lists_sort, ExactParameters) \
    kernel(tile_lists, tile_lists_write, ExactParameters) \
    kernel(tile_lists, tile_lists_boxes, ExactParameters) \
    kernel(tile_lists, tile_lists_behind, ExactParameters) \
    kernel(visible, visible_count, ExactParameters) \
    kernel(visible, visible_write, ExactParameters) \
    kernel(visible, visible_pieces, ExactParameters) \
    kernel(visible, visible_cut, ExactParameters) \
    kernel(visible, visible_parts, ExactParameters) \
    kernel(visible, visible_join, ExactParameters) \
    kernel(visible, visible_spans, ExactParameters) \
    kernel(spans, spans_count, SpansParameters) \
    kernel(spans, spans_runs, SpansParameters) \
    kernel(spans, spans_intervals, SpansParameters) \
    kernel(compact, compact_count, CompactParameters) \
    kernel(compact, compact_write, CompactParameters) \
    kernel(halo, halo_count, HaloParameters) \
    kernel(halo, halo_fill, HaloParameters) \
    kernel(halo, halo_cut, HaloParameters) \
    kernel(filter, filter_count, FilterParameters) \
    kernel(filter, filter_write, FilterParameters) \
    kernel(filter, filter_show, CountParameters) \
    kernel(filter, filter_show_ends, CountParameters) \
    kernel(density, density_lines, DensityParameters) \
    kernel(density, density_smooth, DensityParameters) \
    kernel(density, density_weights, DensityParameters) \
    kernel(density, density_excess, DensityParameters) \
    kernel(carry, carry_runs, CarryParameters) \
    kernel(outline, outline_seen, CountParameters) \
    kernel(outline, outline_push, OutlineParameters) \
    kernel(outline, outline_push_in, OutlineParameters) \
    kernel(outline, outline_parts_count, OutlineParameters) \
    kernel(outline, outline_parts_write, OutlineParameters) \
    kernel(outline, outline_samples_count, OutlineSamplesParameters) \
    kernel(outline, outline_samples_write, OutlineSamplesParameters) \
    kernel(pens, pens_count, PensParameters) \
    kernel(pens, pens_write, PensParameters) \
    kernel(fill, fill_colors, FillColorsParameters) \
    kernel(fill, fill_pixels, FillPixelsParameters) \
    kernel(strokes, strokes_count, StrokeListParameters) \
    kernel(strokes, strokes_list, StrokeListParameters) \
    kernel(strokes, strokes_tiles, StrokesParameters) \
    kernel(strokes, strokes_boxes, StrokesParameters) \
    kernel(strokes, strokes_pixels, StrokesParameters)

/* clang-format on */
#endif
