#pragma once

// Arguments of stages that project segments and compute their samples.

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "tables.hpp"

namespace lineatlas::compute {

/// What `project_clip` needs to drop segments that are hidden as a whole.
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
    glm::vec2 viewport;             ///< pixels
    float step;                     ///< k: pixels per sample, above 0
    std::uint32_t kind_mask;        ///< kinds to draw, bit 1 << kind
    const OcclusionTest* occlusion; ///< null: segments that are hidden whole get samples too
    ClippedTable out;
    /// A uint32 per triangle: its number in the order of the clusters. If it is not null, own faces
    /// become these numbers, for probes that know surfaces.
    Buffer* numbers = nullptr;
    /// Batches of the first segments; without any, each segment is looked at alone.
    BatchTable batches{};
    float centre_overhang = 0; ///< pixels by which centre lines are longer at either end
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

/// The tables of a frame that `temporal` keeps.
struct History {
    Buffer& alpha;   ///< a copy of the frame's atlas, as large
    Buffer& offsets; ///< a copy of ClippedTable::offsets
    Buffer& ranges;  ///< a uint32 per segment
};

/// The segments of a frame that are silhouettes in chains, and where they came from.
struct ChainOrder {
    std::uint32_t first; ///< the first of these segments
    Buffer& origins;     ///< ChainTables::origins
    Buffer& positions;   ///< ChainTables::positions, of `candidates`
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

/// Visible and hidden pieces of segments, for the readback (§4.6).
struct IntervalsArgs {
    SegmentTable table;
    SegmentAtlas atlas;
    glm::vec2 viewport; ///< pixels
    DepthBuffer depth;
    /// Hidden pieces too; then ClippedTable::clipped must be there for hidden segments.
    bool hidden_too;
    IntervalRoom into; ///< out
};

} // namespace lineatlas::compute
