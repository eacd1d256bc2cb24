#pragma once

// The plain C++ twin of every kernel: the same arithmetic in the same order, over spans.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "compute/backend.hpp"

namespace lineatlas::compute::reference {

/// matrices: three rows of 4 floats per object.
void transform(std::span<const glm::vec3> rest, std::span<const std::uint32_t> objects,
               std::span<const float> matrices, std::span<glm::vec3> vertices);
void transform_boxes(std::span<const Cluster> rest, std::span<const std::uint32_t> objects,
                     std::span<const float> matrices, std::span<Cluster> clusters);
void transform_bounds(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> triangles,
                      std::span<Cluster> clusters);
void transform_forget(std::span<const Segment> segments, std::span<const std::uint32_t> objects,
                      std::span<const std::uint8_t> jumped, std::span<std::uint32_t> ranges);

void facing(std::span<const float> vertices, std::span<const std::uint32_t> triangles,
            glm::vec4 eye, std::span<std::uint8_t> front);

/// tiles: tiles_for(depth_size) of them, row by row.
void pyramid(std::span<const float> depth, glm::ivec2 depth_size, std::span<float> tiles);

void cull(std::span<const Cluster> clusters, const glm::mat4& clip_from_world,
          glm::ivec2 depth_size, std::span<const float> tiles, std::span<std::uint8_t> visible);

struct ProjectClipInput {
    std::span<const Segment> segments;
    std::span<const float> vertices;
    std::span<const std::uint32_t> triangles;
    std::span<const std::uint8_t> front;
    glm::mat4 clip_from_world;
    glm::mat4 world_from_clip;
    glm::vec2 viewport;
    float step;
    std::uint32_t kind_mask;
    std::span<const float> tiles{}; ///< the depth pyramid; empty: keep hidden segments
    glm::ivec2 tile_count{0, 0};
    float depth_scale = 1;
    float tolerance = 0;
    bool keep_clipped = false; ///< clipped is written for hidden segments too
};

void project_clip(const ProjectClipInput& input, std::span<ClippedSegment> clipped,
                  std::span<std::uint32_t> counts, std::span<std::uint32_t> arcs);

/// values: n inputs and one more element for the total.
void scan(std::span<std::uint32_t> values, ScanKind kind);

struct AtlasInput {
    std::span<const ClippedSegment> clipped;
    std::span<const std::uint32_t> offsets;
    std::span<const float> depth;
    glm::ivec2 depth_size;
    glm::vec2 viewport;
    float depth_scale;
    std::uint32_t probes;
    float tolerance; ///< window depth that may stand before a line, times w
    AtlasLayout layout;
    std::uint32_t capacity;
    const DepthTile* tile; ///< null: `depth` is whole
};

void atlas(const AtlasInput& input, std::span<std::uint8_t> alpha);

struct TemporalInput {
    std::span<const ClippedSegment> clipped;
    std::span<const std::uint32_t> offsets;
    std::span<const std::uint32_t> offsets_before; ///< empty: there is no frame before
    AtlasLayout layout;
    std::uint32_t capacity;
    std::span<const std::uint8_t> before;
};

/// ranges: of the frame before, then of this one; 16 bits for t0 and t1 each.
void temporal(const TemporalInput& input, std::span<std::uint32_t> ranges,
              std::span<std::uint8_t> alpha);

struct CompactRunsInput {
    std::span<const Segment> segments;
    std::span<const ClippedSegment> clipped;
    std::span<const std::uint32_t> offsets;
    std::span<const std::uint32_t> arcs;
    std::span<const std::uint8_t> alpha;
    AtlasLayout layout;
    std::uint32_t capacity;
    glm::vec2 viewport;
    float half_width;
    bool hidden; ///< runs of hidden samples instead of visible ones
};

/// Writes at most runs.size() runs.
void compact_runs(const CompactRunsInput& input, std::span<Run> runs, FrameRecord& record);

struct FilterInput {
    std::span<const Segment> segments;
    std::span<const ClippedSegment> clipped;
    std::span<const std::uint32_t> offsets;
    std::span<const std::uint32_t> arcs;
    std::span<const std::uint8_t> alpha; ///< before it is changed
    AtlasLayout layout;
    std::uint32_t capacity;
    glm::vec2 viewport;
    float half_width;
    float fill, drop, overshoot, overshoot_variation, undershoot;
    std::span<const Run> runs;
    std::span<const RunCuts> cuts; ///< empty: no gaps
};

/// alpha: the memory of FilterInput::alpha, or other.
void filter(const FilterInput& input, std::span<std::uint8_t> alpha, std::span<Run> filtered,
            const FrameRecord& record, FrameRecord& filtered_record);

struct HaloInput {
    std::span<const Segment> segments;
    std::span<const ClippedSegment> clipped;
    std::span<const Run> runs;
    glm::vec2 viewport;
    float width; ///< from the middle of the nearer stroke to the end of the gap
    float tolerance;
};

/// cuts: as many as runs.
void halo(const HaloInput& input, std::span<RunCuts> cuts);

struct DensityInput {
    std::span<const Segment> segments;
    std::span<const std::uint32_t> arcs;
    std::span<const std::uint8_t> alpha;
    glm::vec2 viewport;
    float limit;
    std::span<const float, LA_KIND_COUNT> priority;
    glm::vec4 focus;
    float far_limit;
};

/// weights: LA_DENSITY_BINS planes of density_cells(viewport).
void density(const DensityInput& input, std::span<Run> runs, std::span<float> weights);

struct IntervalsInput {
    std::span<const Segment> segments;
    std::span<const glm::vec3> vertices;
    std::span<const ClippedSegment> clipped;
    std::span<const std::uint32_t> offsets;
    std::span<const std::uint32_t> arcs;
    std::span<const std::uint8_t> alpha;
    AtlasLayout layout;
    std::uint32_t capacity;
    glm::vec2 viewport;
    std::span<const float> depth;
    glm::ivec2 depth_size;
    float depth_scale;
    float tolerance;
    bool hidden_too;
};

/// Returns how many intervals there are; writes them if they fit.
std::uint32_t intervals(const IntervalsInput& input, std::span<Interval> out);

/// Returns the number of addresses written to `packed`.
std::uint32_t compact_samples(std::span<const std::uint8_t> alpha, std::span<std::uint32_t> packed);

} // namespace lineatlas::compute::reference
