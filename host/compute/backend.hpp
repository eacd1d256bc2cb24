#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "command_log.hpp"
#include "core/atlas_layout.hpp"
#include "core/limits.hpp"
#include "segment_table.h"

namespace lineatlas::compute {

/// Memory that a backend's stages read and write. Made by the backend that uses it; may outlive
/// neither the backend nor, if it wraps other memory, that memory.
class Buffer {
  public:
    explicit Buffer(std::size_t size) : size_(size) {}
    virtual ~Buffer() = default;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    std::size_t size() const { return size_; } ///< in bytes

  private:
    std::size_t size_;
};

/// The constant input of the pipeline, as `LineSet` holds it.
struct SegmentTable {
    Buffer& vertices;  ///< 3 floats each
    Buffer& triangles; ///< 3 uint32 each
    Buffer& segments;  ///< `Segment` each
    std::uint32_t triangle_count;
    std::uint32_t segment_count;
};

/// `project_clip`'s and `scan`'s results: the clipped segment table.
struct ClippedTable {
    Buffer& clipped; ///< `ClippedSegment` per segment, valid where its window length is not 0
    Buffer& offsets; ///< segment_count + 1 uint32: counts l, after `scan` offsets s and the total
    Buffer& arcs; ///< segment_count + 1 uint32: window lengths, after `scan` arc lengths; 1/256 px
};

struct FacingArgs {
    SegmentTable table;
    glm::vec4 eye; ///< Camera::eye()
    Buffer& front; ///< out: a byte per triangle
};

/// Tiles of the depth pyramid per axis.
inline glm::ivec2 tiles_for(glm::ivec2 depth_size) {
    return (depth_size + (LA_TILE - 1)) / LA_TILE;
}

struct PyramidArgs {
    Buffer& depth;         ///< floats in [0, 1], rows from the lower left
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

/// What `project_clip` needs to drop segments that are hidden whole.
struct OcclusionTest {
    Buffer& tiles; ///< of `pyramid`
    glm::ivec2 tile_count;
    float depth_scale;         ///< depth texels per pixel
    float tolerance;           ///< as in AtlasArgs
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
    ClippedTable clipped;
    std::uint32_t segment_count;
    Buffer& depth;         ///< floats in [0, 1], rows from the lower left
    glm::ivec2 depth_size; ///< that it holds: viewport times depth_scale, or a tile's
    glm::vec2 viewport;    ///< pixels
    float depth_scale;     ///< depth texels per pixel
    std::uint32_t probes;  ///< per axis: 1, 2, 3 or 4
    float tolerance;       ///< window depth that may stand before a line, times w
    AtlasLayout layout;
    std::uint32_t capacity;          ///< samples that `alpha` has room for in this layout
    Buffer& alpha;                   ///< out: a byte per texel, 0 hidden to 255 visible
    const DepthTile* tile = nullptr; ///< null: `depth` is whole
};

struct CompactRunsArgs {
    SegmentTable table;
    ClippedTable clipped;
    Buffer& alpha;
    AtlasLayout layout;
    std::uint32_t capacity; ///< samples that `alpha` has room for
    glm::vec2 viewport;     ///< pixels
    float half_width;       ///< of the stroke, in pixels: decides where a join has room
    bool hidden = false;    ///< runs of hidden samples instead of visible ones
    Buffer& runs;           ///< out: `Run` each
    std::uint32_t run_capacity;
    Buffer& record; ///< out: one `FrameRecord`
};

/// What `temporal` remembers of a frame.
struct History {
    Buffer& alpha;   ///< a copy of the frame's atlas, as large
    Buffer& offsets; ///< a copy of ClippedTable::offsets
    Buffer& ranges;  ///< a uint32 per segment
};

struct TemporalArgs {
    ClippedTable clipped;
    std::uint32_t segment_count;
    AtlasLayout layout;
    std::uint32_t capacity; ///< samples that `alpha` has room for
    Buffer& alpha;          ///< in and out: averaged with the frame before
    History history;        ///< in: of the frame before; out: of this one
    bool use_history;       ///< false: there is none yet
};

/// Gaps beside nearer lines (§4.5).
struct HaloArgs {
    SegmentTable table;
    ClippedTable clipped;
    Buffer& runs;   ///< `Run` each, of `compact_runs`
    Buffer& record; ///< its `FrameRecord`: points[0] runs
    std::uint32_t run_capacity;
    glm::vec2 viewport; ///< pixels
    float halo;         ///< gap beside the nearer stroke, pixels
    float half_width;   ///< of the nearer stroke, pixels
    float tolerance;    ///< as in AtlasArgs: a line is nearer if it is so by more than that
    Buffer& cuts;       ///< out: `RunCuts` per run
};

/// What `filter` does to visible strokes; pixels (§4.5). See StrokeFilter.
struct FilterArgs {
    SegmentTable table;
    ClippedTable clipped;
    Buffer& alpha; ///< in and out: samples that become visible get 255
    AtlasLayout layout;
    std::uint32_t capacity; ///< samples that `alpha` has room for
    glm::vec2 viewport;     ///< pixels
    float half_width;       ///< of the stroke, in pixels: decides where a join has room
    float fill, drop, overshoot, overshoot_variation, undershoot;
    Buffer& runs;               ///< in: `Run` each, of `compact_runs`
    Buffer& record;             ///< in: their `FrameRecord`
    Buffer* cuts;               ///< in: of `halo`; null: none
    std::uint32_t run_capacity; ///< of `runs`
    Buffer& filtered;           ///< out: `Run` each
    std::uint32_t filtered_capacity;
    Buffer& filtered_record; ///< out: one `FrameRecord`
};

/// Cells of the density grid per axis.
inline glm::ivec2 density_cells(glm::vec2 viewport) {
    return (glm::ivec2{viewport} + (LA_DENSITY_CELL - 1)) / LA_DENSITY_CELL;
}

/// Line density (§4.5): how much of each line is drawn where.
struct DensityArgs {
    SegmentTable table;
    ClippedTable clipped;
    Buffer& alpha;
    AtlasLayout layout;
    Buffer& runs;   ///< in and out: `Run` each; gets the bin of its line's priority
    Buffer& record; ///< their `FrameRecord`
    std::uint32_t run_capacity;
    glm::vec2 viewport;            ///< pixels
    float limit;                   ///< pixels of line per pixel
    float priority[LA_KIND_COUNT]; ///< of each line kind, 0 to 1
    glm::vec4 focus; ///< centre x and y, radius and falloff in pixels; falloff 0: no focus
    float far_limit; ///< factor of the limit far from the focus
    Buffer& weights; ///< out: floats 0 to 1, LA_DENSITY_BINS planes of density_cells(viewport)
};

/// Visible and hidden pieces of segments, for the readback (§4.6).
struct IntervalsArgs {
    SegmentTable table;
    ClippedTable clipped;
    Buffer& alpha;
    AtlasLayout layout;
    std::uint32_t capacity; ///< samples that `alpha` has room for
    glm::vec2 viewport;     ///< pixels
    Buffer& depth;          ///< as in AtlasArgs
    glm::ivec2 depth_size;
    float depth_scale;
    float tolerance;
    /// Hidden pieces too; then ClippedTable::clipped must be there for hidden segments.
    bool hidden_too;
    Buffer& intervals; ///< out: `Interval` each; none if there are more than it has room for
    std::uint32_t interval_capacity;
    Buffer& total; ///< out: one uint32, how many there are
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

struct CompactSamplesArgs {
    Buffer& alpha;
    std::uint32_t count;  ///< bytes of alpha to look at
    Buffer& packed;       ///< out: uint32 addresses of the visible ones; room for `count`
    Buffer& packed_count; ///< out: one uint32
};

/// Everything that runs as a compute kernel: one method per stage, the same for every backend.
///
/// Calls are asynchronous and run in the order they are made; `finish` and `download` wait. All
/// methods throw DeviceError when the device fails. A backend and its buffers belong to one thread
/// at a time. Integer results are equal bit by bit on every backend, floats within 1e-5 relative.
class Backend {
  public:
    virtual ~Backend() = default;

    /// "reference", or "opencl: <device> (<platform>)".
    virtual std::string description() const = 0;

    /// Device memory; its content is undefined. Never smaller than 16 bytes. Throws Shortage
    /// (core/limits.hpp) where there is not enough.
    virtual std::unique_ptr<Buffer> allocate(std::size_t bytes) = 0;
    /// What one buffer can hold, in bytes; always the same.
    virtual std::uint64_t largest_buffer() const {
        return std::numeric_limits<std::uint64_t>::max();
    }
    /// What all buffers that are still to come can hold.
    virtual std::uint64_t free_memory() const { return std::numeric_limits<std::uint64_t>::max(); }
    /// A buffer over memory of the caller (page-aligned), without a copy where the device can.
    virtual std::unique_ptr<Buffer> wrap(std::span<std::byte> memory) = 0;
    /// Between these two, the memory behind a wrapped buffer is the host's to read and write.
    virtual void begin_host_access(Buffer& buffer) = 0;
    virtual void end_host_access(Buffer& buffer) = 0;

    virtual void upload(Buffer& buffer, std::span<const std::byte> data) = 0;
    /// Into the buffer from a place on, in bytes.
    virtual void upload_at(Buffer& buffer, std::size_t offset, std::span<const std::byte> data) = 0;
    virtual void download(Buffer& buffer, std::span<std::byte> data) = 0; ///< waits

    virtual void transform(const TransformArgs& args) = 0;
    virtual void bounds(const BoundsArgs& args) = 0;
    virtual void forget(const ForgetArgs& args) = 0;
    virtual void pyramid(const PyramidArgs& args) = 0;
    virtual void cull(const CullArgs& args) = 0;
    virtual void facing(const FacingArgs& args) = 0;
    virtual void project_clip(const ProjectClipArgs& args) = 0;
    /// `values`: n inputs and room for one more; see kernels/scan.cl.
    virtual void scan(Buffer& values, std::uint32_t n, ScanKind kind) = 0;
    virtual void atlas(const AtlasArgs& args) = 0;
    virtual void temporal(const TemporalArgs& args) = 0;
    virtual void compact_runs(const CompactRunsArgs& args) = 0;
    virtual void filter(const FilterArgs& args) = 0;
    virtual void halo(const HaloArgs& args) = 0; ///< waits: the host sizes a table of its own
    virtual void density(const DensityArgs& args) = 0;
    virtual void intervals(const IntervalsArgs& args) = 0;
    virtual void compact_samples(const CompactSamplesArgs& args) = 0;

    virtual void flush() = 0;  ///< starts what was submitted
    virtual void finish() = 0; ///< waits for all of it

    /// Keeps the times of all commands from here to end_log(), for a profile. Null, and no log, if
    /// the work of this backend is the host's.
    virtual std::shared_ptr<CommandLog> begin_log() { return nullptr; }
    virtual void end_log() {}
};

/// What a table gets that must hold `needed` bytes, or things of `size` bytes, and may have to grow
/// again soon: room for that where there is some.
inline std::uint64_t roomy(const Backend& backend, std::uint64_t needed, std::size_t size = 1) {
    return with_room_to_grow(needed,
                             std::min(backend.largest_buffer(), backend.free_memory()) / size);
}

/// As Backend::allocate; the message of a Shortage says what the memory was for.
inline std::unique_ptr<Buffer> allocate(Backend& backend, std::size_t bytes,
                                        const Purpose& purpose) {
    return for_purpose(purpose, [&] { return backend.allocate(bytes); });
}

/// Plain C++ on the calling thread: the oracle that kernels are tested against.
std::unique_ptr<Backend> make_reference_backend();

} // namespace lineatlas::compute
