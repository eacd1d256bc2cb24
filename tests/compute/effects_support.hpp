#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compare.hpp"
#include "devices.hpp"

// `filter`, `halo` and `density` on hand-made drawings with known answers: polylines in pixels and
// window depth, with a given depth buffer.
namespace lineatlas::test {

using compute::Buffer;

inline constexpr glm::ivec2 size{320, 240};
inline constexpr float tolerance = 1e-3F, halo = 3, half_width = 1.5F;

using Runs = std::vector<Run>; // testing::Test has a Run of its own

/// Points in pixels and window depth.
using Polyline = std::vector<glm::vec3>;

struct Drawing {
    std::vector<Polyline> lines;
    std::vector<float> depth =
        std::vector<float>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 1);
    std::vector<std::uint32_t> kinds{}; ///< of each line; lines without a kind are from a file

    /// A face parallel to the screen.
    void add_rectangle(glm::ivec2 low, glm::ivec2 high, float at) {
        for (int y = low.y; y < high.y; ++y) {
            for (int x = low.x; x < high.x; ++x) {
                depth[static_cast<std::size_t>(y * size.x + x)] = at;
            }
        }
    }
};

/// The runs of a drawing, and their effects. The eye's clip space is the model's, so w is 1.
class Effects {
  public:
    Effects(std::unique_ptr<compute::Device> made, const Drawing& drawing) : on_(std::move(made)) {
        add_lines(drawing);
        vertices_ = to_device(*on_.device, points_);
        segments_ = to_device(*on_.device, table_);
        none_ = on_.device->allocate(16);
        const auto n = static_cast<std::uint32_t>(table_.size());
        clipped_ = to_device(*on_.device, std::vector<ClippedSegment>(n));
        offsets_ = on_.device->allocate((n + 1) * sizeof(std::uint32_t));
        arcs_ = on_.device->allocate((n + 1) * sizeof(std::uint32_t));
        on_.stages.project_clip({.table = table(),
                                 .front = *none_,
                                 .clip_from_world = glm::mat4{1},
                                 .viewport = glm::vec2{size},
                                 .step = 2,
                                 .kind_mask = ~0U,
                                 .occlusion = nullptr,
                                 .out = {*clipped_, *offsets_, *arcs_}});
        on_.stages.scan(*offsets_, n, compute::ScanKind::saturate);
        on_.stages.scan(*arcs_, n, compute::ScanKind::wrap);
        const auto depth = to_device(*on_.device, drawing.depth);
        alpha_ = to_device(*on_.device, std::vector<std::uint8_t>(capacity));
        on_.stages.atlas({.segment_count = n,
                          .atlas = atlas(),
                          .depth = {*depth, size, 1, tolerance},
                          .viewport = glm::vec2{size},
                          .probes = 3});
        runs_ = on_.device->allocate(run_capacity * sizeof(Run));
        record_ = on_.device->allocate(sizeof(FrameRecord));
        on_.stages.compact({.table = table(),
                            .atlas = atlas(),
                            .viewport = glm::vec2{size},
                            .half_width = half_width,
                            .runs = {*runs_, *record_, run_capacity}});
    }

    std::vector<Run> runs() {
        return read_back<Run>(*on_.device, *runs_,
                              read_back<FrameRecord>(*on_.device, *record_, 1)[0].points[0]);
    }

    std::vector<RunCuts> cuts() {
        const auto cuts = on_.device->allocate(run_capacity * sizeof(RunCuts));
        on_.stages.halo({.table = table(),
                         .clipped = {*clipped_, *offsets_, *arcs_},
                         .runs = {*runs_, *record_, run_capacity},
                         .viewport = glm::vec2{size},
                         .halo = halo,
                         .half_width = half_width,
                         .tolerance = tolerance,
                         .cuts = *cuts});
        return read_back<RunCuts>(*on_.device, *cuts, runs().size());
    }

    std::vector<Run> filtered(const StrokeFilter& filter) {
        const auto filtered = on_.device->allocate(run_capacity * sizeof(Run));
        const auto record = on_.device->allocate(sizeof(FrameRecord));
        on_.stages.filter({.table = table(),
                           .atlas = atlas(),
                           .viewport = glm::vec2{size},
                           .half_width = half_width,
                           .filter = filter,
                           .runs = {*runs_, *record_, run_capacity},
                           .cuts = nullptr,
                           .filtered = {*filtered, *record, run_capacity}});
        return read_back<Run>(*on_.device, *filtered,
                              read_back<FrameRecord>(*on_.device, *record, 1)[0].points[0]);
    }

    std::vector<float> weights(float limit, glm::vec4 focus = {0, 0, 0, 0}, float far_limit = 1) {
        const glm::ivec2 cells = compute::density_cells(glm::vec2{size});
        const std::size_t count =
            LA_DENSITY_BINS * static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
        const auto weights = on_.device->allocate(count * sizeof(float));
        const auto grid = on_.device->allocate(count * sizeof(std::uint32_t));
        on_.stages.density({.table = table(),
                            .atlas = atlas(),
                            .runs = {*runs_, *record_, run_capacity},
                            .viewport = glm::vec2{size},
                            .density = {.limit = limit, .priority = {0.2F, 0.4F, 0.6F, 0.8F, 1}},
                            .focus = focus,
                            .far_limit = far_limit,
                            .grid = *grid,
                            .weights = *weights});
        return read_back<float>(*on_.device, *weights, count);
    }

  private:
    void add_lines(const Drawing& drawing) {
        for (std::size_t path = 0; path < drawing.lines.size(); ++path) {
            const Polyline& line = drawing.lines[path];
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                table_.push_back(
                    {.p = vertex(line[i]),
                     .q = vertex(line[i + 1]),
                     .face_a = LA_NO_FACE,
                     .face_b = LA_NO_FACE,
                     .from_start = static_cast<std::uint32_t>(i),
                     .to_end = static_cast<std::uint32_t>(line.size() - 2 - i),
                     .path = static_cast<std::uint32_t>(path),
                     .tag = drawing.kinds.empty() ? LA_KIND_FILE : drawing.kinds[path]});
            }
        }
    }

    /// The index of a point in clip space; equal points have one vertex.
    std::uint32_t vertex(glm::vec3 window) {
        const glm::vec3 clip = window / glm::vec3{size, 1} * 2.0F - 1.0F;
        const auto found = std::ranges::find(points_, clip);
        const auto index = static_cast<std::uint32_t>(found - points_.begin());
        if (found == points_.end()) points_.push_back(clip);
        return index;
    }

    compute::SegmentTable table() {
        return {*vertices_, *none_, *segments_, 0, static_cast<std::uint32_t>(table_.size())};
    }
    compute::SegmentAtlas atlas() { return {{*clipped_, *offsets_, *arcs_}, *alpha_, capacity}; }

    static constexpr std::uint32_t capacity = 1U << 16U, run_capacity = 1U << 12U;
    DeviceStages on_;
    std::vector<glm::vec3> points_;
    std::vector<Segment> table_;
    std::unique_ptr<Buffer> vertices_, segments_, none_, clipped_, offsets_, arcs_, alpha_, runs_,
        record_;
};
class EffectsTest : public testing::TestWithParam<TestDevice> {
  protected:
    static Effects make(const Drawing& drawing) { return {GetParam().make(), drawing}; }
};

} // namespace lineatlas::test
