#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "compute/stages/batches.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::test {

/// The state of a frame after some stage, on the host.
struct FrameState {
    std::vector<std::uint8_t> front;
    std::vector<float> tiles;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> counts, lengths; ///< after project_clip
    std::vector<std::uint32_t> offsets, arcs;   ///< after scan
    std::vector<std::uint8_t> alpha;
    std::vector<Interval> intervals;
    std::vector<Run> runs;
    FrameRecord record{};
    std::vector<RunCuts> cuts;
    std::vector<std::uint32_t> flags; ///< of the runs, after density
    std::vector<float> weights;
};

struct StageSettings {
    int depth_scale = 2;
    std::uint32_t probes = 3;               ///< per axis
    std::uint32_t run_capacity = 1U << 20U; ///< room for runs and for intervals
    int tile_pixels = 130;                  ///< tiles of the tiled depth buffer
    // Values of a style that change something in every scene.
    float half_width = 1;
    StrokeFilter filter{.fill_holes = 4,
                        .drop_runs = 4,
                        .overshoot = 12,
                        .overshoot_variation = 0.3F,
                        .undershoot = 2,
                        .halo = 3};
    Density density{.limit = 0.1F, .priority = {0.5F, 0.6F, 0.5F, 1, 1}};
    float far_limit = 0.5F;

    /// The focus of `density`, beside the middle of the picture.
    static glm::vec4 focus(glm::vec2 viewport) {
        return {0.4F * viewport.x, 0.6F * viewport.y, 30, 80};
    }
};

/// The tolerance before a line: one pixel's width in window depth, times w.
float depth_tolerance(const Camera& camera);

/// The number of samples in the state's atlas. It is too small if a test has cut the atlas.
std::uint32_t capacity_of(const FrameState& state);

/// The buffers of one device for a line set. Runs the stages one at a time.
class FrameStages {
  public:
    FrameStages(std::unique_ptr<compute::Device> device, const LineSet& lines,
                const StageSettings& settings = {});

    compute::Device& device() { return *device_; }
    const StageSettings& settings() const { return settings_; }

    void pyramid(const Camera& camera, const std::vector<float>& depth, FrameState& state);

    /// Culls against the pyramid of the last call.
    std::vector<std::uint32_t> cull(const Camera& camera, const std::vector<Cluster>& clusters);

    /// Uses the pyramid of the last call if `cull_hidden`.
    void project(const Camera& camera, bool cull_hidden, FrameState& state);

    void scan(FrameState& state);

    void atlas(const Camera& camera, const std::vector<float>& depth, FrameState& state);

    /// The same with a depth buffer that is cut into tiles.
    void tiled_atlas(const Camera& camera, const std::vector<float>& depth, FrameState& state);

    /// Averages `now` with the frame before it.
    void temporal(const FrameState& before, FrameState& now);

    void compact(const Camera& camera, FrameState& state);

    void intervals(const Camera& camera, const std::vector<float>& depth, bool hidden_too,
                   FrameState& state);

    /// Of the runs in `state`.
    void halo(const Camera& camera, FrameState& state);

    /// Filters the runs in `state`, with its gaps if it has any.
    void filter(const Camera& camera, FrameState& state);

    /// Thins the runs in `state`, with a limit that hides some.
    void density(const Camera& camera, FrameState& state);

    /// The runs in `state` with two pens. The second one draws outlines, which are told by depth.
    std::vector<Run> pens(const Camera& camera, const std::vector<float>& depth,
                          const FrameState& state);

    /// The coverage of every pixel by the strokes of the runs in `state`. The strokes are dashed,
    /// thinned by the weights in `state`, and drawn in two pieces.
    std::vector<std::uint8_t> strokes(const Camera& camera, const FrameState& state);

  private:
    compute::SegmentTable table() {
        return {*vertices_, *triangles_, *segments_, triangle_count_, n_};
    }

    compute::SegmentAtlas atlas_of(compute::Buffer& alpha, std::uint32_t capacity) {
        return {{*clipped_, *offsets_, *arcs_}, alpha, capacity};
    }
    compute::DepthBuffer depth_of(compute::Buffer& texels, glm::ivec2 size, const Camera& camera);

    std::unique_ptr<compute::Device> device_;
    compute::Stages stages_;
    compute::Batches batches_{stages_}; ///< batches of segments, used from the second project() on
    StageSettings settings_;
    std::uint32_t n_, triangle_count_;
    std::unique_ptr<compute::Buffer> vertices_, triangles_, segments_, front_, clipped_, offsets_,
        arcs_, tiles_;
};

} // namespace lineatlas::test
