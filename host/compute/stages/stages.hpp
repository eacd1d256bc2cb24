#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "compute/kernels.hpp"
#include "core/atlas_layout.hpp"
#include "core/limits.hpp"
#include "core/screen_bounds.hpp"
#include "core/surface_view.hpp"
#include "segment_table.h"

namespace lineatlas::compute {

/// Where silhouettes of smooth surfaces may run, as LineSet::contours has it.
struct ContourTables {
    Buffer* corners = nullptr; ///< `ContourCorner` each
    Buffer* edges = nullptr;   ///< `ContourEdge` each
    Buffer* faces = nullptr;   ///< 3 uint32 each: edges
    Buffer* patches = nullptr; ///< per triangle a uint32: of which surface it is, or LA_NO_SURFACE
    std::uint32_t edge_count = 0;
    std::uint32_t face_count = 0;   ///< the last candidates
    std::uint32_t replaced = 0;     ///< candidates before them that they stand for
    std::uint32_t vertex_count = 0; ///< of the mesh
};

/// Segments that are drawn where they are silhouettes: the last ones of a table.
struct SilhouetteCandidates {
    std::uint32_t first = 0; ///< in the segment table
    std::uint32_t count = 0;
    /// Per vertex a uint32: where its part of `ends` begins, and one more; null if there are none.
    Buffer* end_offsets = nullptr;
    Buffer* ends = nullptr; ///< 2 uint32 per candidate: 2 i + end, by the vertex there
    std::optional<ContourTables> contours{};

    /// Of them, how many are edges of the mesh that no contour stands for, and how many are edges.
    std::uint32_t kept_edges() const { return edges() - (contours ? contours->replaced : 0); }
    std::uint32_t edges() const { return count - (contours ? contours->face_count : 0); }
};

/// The constant input of the pipeline, as `LineSet` holds it.
struct SegmentTable {
    Buffer& vertices;  ///< 3 floats each
    Buffer& triangles; ///< 3 uint32 each
    Buffer& segments;  ///< `Segment` each
    std::uint32_t triangle_count;
    std::uint32_t segment_count;
    SilhouetteCandidates candidates{};
    /// Of the silhouettes of a frame's own table, as chain_write has them; null: it has them where
    /// the line set has its candidates.
    Buffer* origins = nullptr;
};

/// `project_clip`'s and `scan`'s results: the clipped segment table.
struct ClippedTable {
    Buffer& clipped; ///< `ClippedSegment` per segment, valid where its window length is not 0
    Buffer& offsets; ///< segment_count + 1 uint32: counts l, after `scan` offsets s and the total
    Buffer& arcs; ///< segment_count + 1 uint32: window lengths, after `scan` arc lengths; 1/256 px
};

/// The segments of a frame and the visibility of their samples.
struct SegmentAtlas {
    ClippedTable clipped;
    Buffer& alpha; ///< a byte per texel, 0 hidden to 255 visible
    AtlasLayout layout;
    std::uint32_t capacity; ///< samples that `alpha` has room for in this layout

    AtlasRows rows() const { return {layout.width, layout.pitch, capacity}; }
};

/// What a depth buffer shows, for probes that know surfaces.
struct SurfaceTables {
    Buffer& numbers; ///< a uint32 per texel: of a triangle in the order of its clusters, or
                     ///< LA_NO_FACE
    Buffer& planes;  ///< of `planes`
    Buffer& patches; ///< a uint32 per triangle, in the same order: its smooth patch
    bool parallel;   ///< the view
    float bend;      ///< of SurfaceView
};

/// A depth buffer, and how much of it may stand before a line.
struct DepthBuffer {
    Buffer& texels;                          ///< floats in [0, 1], rows from the lower left
    glm::ivec2 size;                         ///< that it holds: viewport times scale, or a tile's
    float scale;                             ///< texels per pixel
    float tolerance;                         ///< window depth that may stand before a line, times w
    std::optional<SurfaceTables> surfaces{}; ///< then own faces are numbers in ClippedTable

    /// As kernels take it.
    SurfaceParameters surface_parameters() const {
        if (!surfaces) return {.known = 0, .parallel = 0, .bend = 0};
        return {.known = 1, .parallel = surfaces->parallel ? 1U : 0U, .bend = surfaces->bend};
    }
};

/// Where the objects of a model stand (§4.1).
struct TransformArgs {
    Buffer& rest;     ///< 3 floats per vertex: as the model was made
    Buffer& objects;  ///< per vertex a uint32
    Buffer& matrices; ///< per object three rows of 4 floats: world from object
    std::uint32_t vertex_count;
    Buffer& vertices; ///< out: moved
    Buffer& drawn;    ///< out: the same, for GL
    Buffer& rest_clusters;
    Buffer& cluster_objects; ///< per cluster a uint32
    std::uint32_t cluster_count;
    Buffer& clusters; ///< out: with boxes around the moved ones
};

/// New boxes for clusters whose vertices have changed.
struct BoundsArgs {
    Buffer& vertices;
    Buffer& triangles; ///< 3 uint32 each, in the order of the clusters
    Buffer& clusters;  ///< in and out
    std::uint32_t count;
};

/// What `temporal` is not to average: lines of objects that have moved far.
struct ForgetArgs {
    Buffer& segments;
    std::uint32_t segment_count;
    Buffer& objects; ///< as in TransformArgs
    Buffer& jumped;  ///< per object a byte: 1 if it has
    Buffer& ranges;  ///< in and out, of History
};

/// The triangles of a model as `depth` draws them.
struct MeshletTables {
    Buffer& clusters;    ///< `Cluster` each
    Buffer& meshlets;    ///< `Meshlet` each
    Buffer& vertex_list; ///< uint32: the lists of all meshlets
    Buffer& corners;     ///< bytes: their triangles
    std::uint32_t count; ///< clusters
};

/// The depth of the triangles.
struct DepthArgs {
    MeshletTables model;
    Buffer& vertices; ///< as in SegmentTable
    glm::mat4 clip_from_world;
    glm::ivec2 whole_size;     ///< texels of the whole picture
    glm::ivec2 origin;         ///< the first texel of `depth` in it
    glm::ivec2 size;           ///< texels of `depth`
    TexelRectangle covered;    ///< of these what is wanted; what lies beside may stay as it is
    Buffer& depth;             ///< out: as in DepthBuffer
    Buffer& tiles;             ///< out: as of `pyramid`, where something is wanted
    Buffer& seen;              ///< out: a byte per cluster, 1 if any of it may be seen
    Buffer* numbers = nullptr; ///< out: as of SurfaceTables; null: nobody asks
};

/// The planes of a model's triangles on the screen.
struct PlanesArgs {
    MeshletTables model;
    Buffer& vertices; ///< as in SegmentTable
    SurfaceView view;
    float contact;  ///< what is nearer to a plane than this touches it; world units
    Buffer* seen;   ///< of `depth`: clusters that matter; null: all
    Buffer& planes; ///< out: 4 floats per triangle, in the order of the clusters
};

/// Tiles of the depth pyramid per axis.
inline glm::ivec2 tiles_for(glm::ivec2 depth_size) {
    return (depth_size + (LA_TILE - 1)) / LA_TILE;
}

struct PyramidArgs {
    Buffer& depth;         ///< as in DepthBuffer
    glm::ivec2 depth_size; ///< texels
    Buffer& tiles;         ///< out: a float per tile, tiles_for(depth_size) of them, row by row
};

struct CullArgs {
    Buffer& clusters; ///< `Cluster` each
    std::uint32_t count;
    glm::mat4 clip_from_world;
    glm::ivec2 depth_size;
    Buffer& tiles;   ///< of `pyramid`
    Buffer& visible; ///< out: a byte per cluster, 1 if it may be seen
};

struct FacingArgs {
    SegmentTable table;
    glm::vec4 eye; ///< Camera::eye()
    Buffer& front; ///< out: a byte per triangle
};

/// Which candidates of the table are silhouettes.
struct ContourArgs {
    ContourTables contours;
    glm::vec4 eye;    ///< Camera::eye()
    Buffer& front;    ///< of `facing`
    Buffer& vertices; ///< in: those of the mesh; out, behind them: 6 floats per edge
    Buffer& crossed;  ///< scratch: a byte per edge
    Buffer& ends;     ///< out: 2 uint32 per candidate, see kernels/contour.cl
};

/// Which candidates are silhouettes.
struct SilhouetteArgs {
    SegmentTable table;
    Buffer* contour_ends; ///< of `contour`; null where there are no contours
    Buffer& front;        ///< of `facing`
    Buffer& numbers;      ///< out: per candidate the number of silhouettes before it, then of all
};

/// The silhouettes of a frame as paths: see kernels/chain.cl for what each table holds.
struct ChainArgs {
    SegmentTable table;
    Buffer* contour_ends; ///< as in SilhouetteArgs
    bool lifted;          ///< contours are drawn where visibility is asked of them
    glm::vec4 eye;        ///< Camera::eye()
    Buffer& numbers;      ///< of `silhouette`
    std::uint32_t count;  ///< silhouettes, above 0
    Buffer& chosen;       ///< scratch: a uint32 per silhouette
    Buffer& ways;         ///< scratch: two `ChainWay` per silhouette
    Buffer& longer;       ///< scratch: the same
    Buffer& going;        ///< scratch: a uint32 for each of most_chain_steps
    Buffer& places;       ///< scratch: `ChainPlace` per silhouette
    Buffer& starts;       ///< scratch: a uint32 per silhouette and one more
    Buffer& ordered;      ///< out: `Segment` each, from candidates.first on
    Buffer& origins;      ///< out: a uint32 per silhouette, in their new order
    Buffer& positions;    ///< out: a uint32 per candidate
};
/// Steps in which the ways of any number of silhouettes get to their ends.
inline constexpr std::uint32_t most_chain_steps = 34;

/// What `project_clip` needs to drop segments that are hidden whole.
struct OcclusionTest {
    Buffer& tiles; ///< of `pyramid`
    glm::ivec2 tile_count;
    float depth_scale;         ///< depth texels per pixel
    float tolerance;           ///< as in DepthBuffer
    bool keep_clipped = false; ///< ClippedTable::clipped is written for hidden segments too
};

struct ProjectClipArgs {
    SegmentTable table;
    Buffer& front;
    glm::mat4 clip_from_world;
    glm::mat4 world_from_clip;
    glm::vec2 viewport;             ///< pixels
    float step;                     ///< k: pixels per sample, above 0
    std::uint32_t kind_mask;        ///< kinds to draw, bit 1 << kind
    const OcclusionTest* occlusion; ///< null: segments that are hidden whole get samples too
    ClippedTable out;
    /// A uint32 per triangle: its number in the order of the clusters. Not null: own faces become
    /// those, for probes that know surfaces.
    Buffer* numbers = nullptr;
};

enum class ScanKind {
    saturate, ///< the sum stops at 2^32 - 1: counts and offsets
    wrap,     ///< the sum is taken modulo 2^32: arc lengths
};

/// A part of a depth buffer that is too large to be held whole.
struct DepthTile {
    glm::ivec2 origin{0, 0}; ///< its first texel in the whole
    /// Samples in these texels of the whole, from `core_low` up to, without, `core_high`, are
    /// computed.
    glm::ivec2 core_low{0, 0}, core_high{0, 0};
};

struct AtlasArgs {
    std::uint32_t segment_count;
    SegmentAtlas atlas; ///< alpha: out
    DepthBuffer depth;
    glm::vec2 viewport;              ///< pixels
    std::uint32_t probes;            ///< per axis: 1, 2, 3 or 4
    const DepthTile* tile = nullptr; ///< null: `depth` is whole
};

/// What `temporal` remembers of a frame.
struct History {
    Buffer& alpha;   ///< a copy of the frame's atlas, as large
    Buffer& offsets; ///< a copy of ClippedTable::offsets
    Buffer& ranges;  ///< a uint32 per segment
};

/// Which segments of a frame are silhouettes in chains, and where they came from.
struct ChainOrder {
    std::uint32_t first; ///< of them
    Buffer& origins;     ///< ChainArgs::origins
    Buffer& positions;   ///< ChainArgs::positions, of `candidates`
    std::uint32_t candidates;
    Buffer& positions_before; ///< in: of the frame before, 0 if it had none; out: of this one
};

struct TemporalArgs {
    std::uint32_t segment_count;
    SegmentAtlas atlas;                 ///< alpha: in and out, averaged with the frame before
    History history;                    ///< in: of the frame before; out: of this one
    std::uint32_t use;                  ///< LA_HISTORY_*: what the history is good for
    const ChainOrder* chains = nullptr; ///< null: all segments stand where they did
};

struct CompactArgs {
    SegmentTable table;
    SegmentAtlas atlas;
    glm::vec2 viewport;  ///< pixels
    float half_width;    ///< of the stroke, in pixels: decides where a join has room
    bool hidden = false; ///< runs of hidden samples instead of visible ones
    Buffer& runs;        ///< out: `Run` each
    std::uint32_t run_capacity;
    Buffer& record; ///< out: one `FrameRecord`
};

/// Gaps beside nearer lines (§4.5).
struct HaloArgs {
    SegmentTable table;
    ClippedTable clipped;
    Buffer& runs;   ///< `Run` each, of `compact`
    Buffer& record; ///< its `FrameRecord`: points[0] runs
    std::uint32_t run_capacity;
    glm::vec2 viewport; ///< pixels
    float halo;         ///< gap beside the nearer stroke, pixels
    float half_width;   ///< of the nearer stroke, pixels
    float tolerance;    ///< as in DepthBuffer: a line is nearer if it is so by more than that
    Buffer& cuts;       ///< out: `RunCuts` per run
};

/// Changes to visible strokes (§4.5).
struct FilterArgs {
    SegmentTable table;
    SegmentAtlas atlas;         ///< alpha: in and out; samples that become visible get 255
    glm::vec2 viewport;         ///< pixels
    float half_width;           ///< as in CompactArgs
    StrokeFilter filter;        ///< what to do
    Buffer& runs;               ///< in: `Run` each, of `compact`
    Buffer& record;             ///< in: their `FrameRecord`
    Buffer* cuts;               ///< in: of `halo`; null: none
    std::uint32_t run_capacity; ///< of `runs`
    Buffer& filtered;           ///< out: `Run` each
    std::uint32_t filtered_capacity;
    Buffer& filtered_record; ///< out: one `FrameRecord`
};

/// Pixels per axis of a cell of the density grid: LA_DENSITY_CELL, or so many times that that no
/// picture has more than 1024 cells a side. So the grid of a poster takes no more than 64 MiB.
inline int density_cell(glm::vec2 viewport) {
    constexpr int most = 1024 * LA_DENSITY_CELL;
    const int longer = static_cast<int>(std::max(viewport.x, viewport.y));
    return LA_DENSITY_CELL * std::max((longer + most - 1) / most, 1);
}

/// Cells of the density grid per axis.
inline glm::ivec2 density_cells(glm::vec2 viewport) {
    const int cell = density_cell(viewport);
    return (glm::ivec2{viewport} + (cell - 1)) / cell;
}

/// Line density (§4.5): how much of each line is drawn where.
struct DensityArgs {
    SegmentTable table;
    SegmentAtlas atlas;
    Buffer& runs;   ///< in and out: `Run` each; gets the bin of its line's priority
    Buffer& record; ///< their `FrameRecord`
    std::uint32_t run_capacity;
    glm::vec2 viewport; ///< pixels
    Density density;    ///< limit and priorities
    glm::vec4 focus;    ///< centre x and y, radius and falloff in pixels; falloff 0: no focus
    float far_limit;    ///< factor of the limit far from the focus
    /// Where segments come in chunks: what was drawn per cell and bin of those before,
    /// nothing before the first (see Stages::read_density_grid()).
    std::span<const std::uint32_t> drawn_before{};
    Buffer& weights; ///< out: floats 0 to 1, LA_DENSITY_BINS planes of density_cells(viewport)
};

/// Visible and hidden pieces of segments, for the readback (§4.6).
struct IntervalsArgs {
    SegmentTable table;
    SegmentAtlas atlas;
    glm::vec2 viewport; ///< pixels
    DepthBuffer depth;
    /// Hidden pieces too; then ClippedTable::clipped must be there for hidden segments.
    bool hidden_too;
    Buffer& intervals; ///< out: `Interval` each; none if there are more than it has room for
    std::uint32_t interval_capacity;
    Buffer& total; ///< out: one uint32, how many there are
};

/// What the exact method works on between its stages; see kernels/exact_tables.h for what each
/// holds.
struct ExactArgs {
    SegmentTable table;
    ClippedTable clipped;       ///< `offsets` is not read
    ExactParameters parameters; ///< without `chunk` and `chunks`, which are the device's
    Buffer& screen;             ///< 4 floats per vertex
    Buffer& faces;              ///< `ScreenFace` per triangle
    Buffer& planes;             ///< 4 floats per triangle
    Buffer& occluders;          ///< a uint32 per tile
    Buffer& ends;               ///< face_chunks uint32 per tile, and the number of entries
    Buffer& groups;             ///< a uint32 per tile, and the number of groups
    Buffer& entries;            ///< `Entry` each, entry_capacity of them
    Buffer& blocks;             ///< LA_GROUP_FLOATS floats per group, group_capacity of them
    Buffer& boxes;              ///< LA_BOX_FLOATS floats for group_capacity + LA_GROUP groups
    Buffer& kept;               ///< 4 floats per segment
    Buffer& span_offsets;       ///< out: a uint32 per segment, and the number of spans
    Buffer& spans;              ///< out: 2 floats per span; none if span_capacity is too small
};

/// The visible parts of all segments, as `visible` leaves them.
struct SpanTable {
    Buffer& offsets;
    Buffer& spans;
    std::uint32_t capacity; ///< spans that there is room for
};

/// What lies beside every segment that is seen, for `visible` to look at.
struct OutlineArgs {
    SegmentTable table;
    ClippedTable clipped;
    SpanTable spans;    ///< what is seen of the segments
    glm::vec2 viewport; ///< pixels
    float depth;        ///< pixels that a body must be deep on the other side
    bool parallel;      ///< a parallel view
    glm::mat4 clip_from_world;
    std::uint32_t lift; ///< as in ExactParameters
    Buffer& pushed;     ///< out: `ClippedSegment`, 2 per segment, then LA_OUTLINE_WITHIN
};

/// Parts of segments that have the background on one side. They may overlap.
struct OutlineTable {
    Buffer& offsets; ///< per segment and one more
    Buffer& parts;   ///< two floats each, from and to, in the units of runs
};

/// Of what is seen of the ways beside segments, which parts are outline.
struct OutlinePartsArgs {
    std::uint32_t segment_count;
    SpanTable beside, within; ///< of the ways of outline_push() and outline_push_in()
    Buffer& offsets;          ///< out: segment_count + 1 uint32
    Buffer& parts;            ///< out: 2 floats each; none if `part_capacity` is too small
    std::uint32_t part_capacity;
};

/// The same of samples, by the depth buffer.
struct OutlineSamplesArgs {
    SegmentTable table;
    ClippedTable clipped;
    std::uint32_t sample_capacity; ///< as in SegmentAtlas
    DepthBuffer depth;
    glm::vec2 viewport; ///< pixels
    float body;         ///< pixels that a body must be deep on the other side
    Buffer& offsets;    ///< out: segment_count + 1 uint32
    Buffer& parts;      ///< out: 2 floats each; none if `part_capacity` is too small
    std::uint32_t part_capacity;
};

/// Which pen draws which run.
struct PensArgs {
    SegmentTable table;
    /// Per segment of the line set a uint32: pen, and from bit 16 that of its outline.
    Buffer& segment_pens;
    const OutlineTable* outline; ///< null: nothing is one
    Buffer& runs;                ///< in: `Run` each
    Buffer& record;              ///< in: their `FrameRecord`
    std::uint32_t run_capacity;
    Buffer& drawn; ///< out: `Run` each
    std::uint32_t drawn_capacity;
    Buffer& drawn_record; ///< out: one `FrameRecord`
};

/// Runs of spans, as CompactArgs of samples.
struct SpanRunsArgs {
    SegmentTable table;
    ClippedTable clipped; ///< `offsets`: all 0
    SpanTable spans;
    glm::vec2 viewport; ///< pixels
    float half_width;   ///< as in CompactArgs
    bool hidden;        ///< runs of what is not visible instead
    Buffer& runs;       ///< out: `Run` each
    std::uint32_t run_capacity;
    Buffer& record; ///< out: one `FrameRecord`
};

/// Intervals of spans, as IntervalsArgs of samples.
struct SpanIntervalsArgs {
    SegmentTable table;
    ClippedTable clipped; ///< `offsets`: all 0
    SpanTable spans;
    glm::vec2 viewport; ///< pixels
    bool hidden_too;    ///< hidden pieces too
    Buffer& intervals;  ///< out: `Interval` each; none if there are more than it has room for
    std::uint32_t interval_capacity;
    Buffer& total; ///< out: one uint32, how many there are
};

/// The stages that are kernels, each with the kernels that it launches, in which order and on which
/// tables; the same on every device. As asynchronous as the device is.
class Stages {
  public:
    /// `device` must outlive it.
    explicit Stages(Device& device) : device_(device), tuning_(device.tuning()) {}

    Device& device() const { return device_; }

    void transform(const TransformArgs& args);
    void transform_bounds(const BoundsArgs& args);
    void transform_forget(const ForgetArgs& args);
    /// Throws DeviceError for more clusters than the device can sort.
    void depth(const DepthArgs& args);
    void planes(const PlanesArgs& args);
    void pyramid(const PyramidArgs& args);
    void cull(const CullArgs& args);
    void facing(const FacingArgs& args);
    void contour(const ContourArgs& args);
    void silhouette(const SilhouetteArgs& args);
    void chain(const ChainArgs& args);
    void project_clip(const ProjectClipArgs& args);
    /// `values`: n inputs and room for one more; see kernels/scan.cl.
    void scan(Buffer& values, std::uint32_t n, ScanKind kind);
    void atlas(const AtlasArgs& args);
    void temporal(const TemporalArgs& args);
    void intervals(const IntervalsArgs& args);
    void surfaces(const ExactArgs& args);
    void tile_lists(const ExactArgs& args);
    void visible(const ExactArgs& args);
    void span_runs(const SpanRunsArgs& args);
    void span_intervals(const SpanIntervalsArgs& args);
    void outline_push(const OutlineArgs& args);
    /// `beside_offsets`: of what is seen of the ways of outline_push().
    void outline_push_in(const OutlineArgs& args, Buffer& beside_offsets);
    void outline_parts(const OutlinePartsArgs& args);
    void outline_samples(const OutlineSamplesArgs& args);
    void pens(const PensArgs& args);
    void compact(const CompactArgs& args);
    void halo(const HaloArgs& args); ///< waits: the host sizes a table of its own
    void filter(const FilterArgs& args);
    void density(const DensityArgs& args);
    /// What the last density() has added up, with what was there before: for the next chunk.
    void read_density_grid(std::vector<std::uint32_t>& drawn, glm::vec2 viewport);

  private:
    /// Launches `items` work-items in groups of `group`; nothing if there are none.
    template <class K>
    void launch(std::uint32_t items, std::uint32_t group, const typename K::Parameters& parameters,
                const typename K::Tables& tables, const Kernel& kernel = kernel_of<K>()) {
        if (items == 0) return;
        const auto list = K::list(tables);
        device_.launch({kernel, std::as_bytes(std::span{&parameters, 1}), list, items, group});
    }

    /// Of what `wanted` asks for, per block of segments, scanned.
    Buffer& count_spans(const SegmentTable& table, const ClippedTable& clipped,
                        const SpanTable& spans, const SpansParameters& parameters);
    /// A table of its own for at least `count` uint32, kept from call to call.
    Buffer& scratch(std::unique_ptr<Buffer>& buffer, std::size_t count);

    Device& device_;
    const Tuning& tuning_; ///< of device_
    std::unique_ptr<Buffer> scan_sums_, block_counts_, run_counts_, halo_ends_, halo_lists_;
    std::unique_ptr<Buffer> depth_places_, depth_boxes_, depth_nearest_, depth_order_;
    std::unique_ptr<Buffer> depth_total_, depth_next_, depth_no_numbers_;
    std::unique_ptr<Buffer> density_grid_, density_rows_, density_drawn_, density_excesses_;
};

/// What a table gets that must hold `needed` bytes, or things of `size` bytes, and may have to grow
/// again soon: room for that where there is some.
inline std::uint64_t room_to_grow(const Device& device, std::uint64_t needed,
                                  std::size_t size = 1) {
    return with_room_to_grow(needed,
                             std::min(device.largest_buffer(), device.free_memory()) / size);
}

/// A first guess at how many elements a table must hold that can grow: no more than a buffer does.
template <class Element>
std::uint32_t first_capacity(const Device& device, std::uint32_t guess) {
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(guess, device.largest_buffer() / sizeof(Element)));
}

/// How many elements a table gets that must hold `needed` of them and may have to grow again.
template <class Element>
std::uint32_t capacity_for(const Device& device, std::uint32_t needed) {
    constexpr std::uint64_t most_counted = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(
        std::min(room_to_grow(device, needed, sizeof(Element)), most_counted));
}

/// As Device::allocate; the message of a Shortage says what the memory was for.
inline std::unique_ptr<Buffer> allocate(Device& device, std::size_t bytes, const Purpose& purpose) {
    return for_purpose(purpose, [&] { return device.allocate(bytes); });
}

} // namespace lineatlas::compute
