// `halo` and `density` on hand-made drawings with known answers, on every device and in plain C++:
// polylines given in pixels and window depth, before a depth buffer that is given too.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compare.hpp"
#include "compute/backend.hpp"
#include "devices.hpp"

namespace lineatlas::test {
namespace {

using compute::Backend;
using compute::Buffer;

constexpr glm::ivec2 size{320, 240};
constexpr float tolerance = 1e-3F, halo = 3, half_width = 1.5F;

using Runs = std::vector<Run>; // testing::Test has a Run of its own

/// Points in pixels and window depth.
using Polyline = std::vector<glm::vec3>;

struct Drawing {
    std::vector<Polyline> lines;
    std::vector<float> depth =
        std::vector<float>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 1);
    std::vector<std::uint32_t> kinds{}; ///< of each line; without one: from a file

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
    Effects(std::unique_ptr<Backend> backend, const Drawing& drawing)
        : backend_(std::move(backend)) {
        add_lines(drawing);
        vertices_ = to_device(*backend_, points_);
        segments_ = to_device(*backend_, table_);
        none_ = backend_->allocate(16);
        const auto n = static_cast<std::uint32_t>(table_.size());
        clipped_ = to_device(*backend_, std::vector<ClippedSegment>(n));
        offsets_ = backend_->allocate((n + 1) * sizeof(std::uint32_t));
        arcs_ = backend_->allocate((n + 1) * sizeof(std::uint32_t));
        backend_->project_clip({.table = table(),
                                .front = *none_,
                                .clip_from_world = glm::mat4{1},
                                .world_from_clip = glm::mat4{1},
                                .viewport = glm::vec2{size},
                                .step = 2,
                                .kind_mask = ~0U,
                                .occlusion = nullptr,
                                .out = {*clipped_, *offsets_, *arcs_}});
        backend_->scan(*offsets_, n, compute::ScanKind::saturate);
        backend_->scan(*arcs_, n, compute::ScanKind::wrap);
        const auto depth = to_device(*backend_, drawing.depth);
        alpha_ = to_device(*backend_, std::vector<std::uint8_t>(layout_.texels(capacity)));
        backend_->atlas({.clipped = {*clipped_, *offsets_, *arcs_},
                         .segment_count = n,
                         .depth = *depth,
                         .depth_size = size,
                         .viewport = glm::vec2{size},
                         .depth_scale = 1,
                         .probes = 3,
                         .tolerance = tolerance,
                         .layout = layout_,
                         .capacity = capacity,
                         .alpha = *alpha_});
        runs_ = backend_->allocate(run_capacity * sizeof(Run));
        record_ = backend_->allocate(sizeof(FrameRecord));
        backend_->compact_runs({.table = table(),
                                .clipped = {*clipped_, *offsets_, *arcs_},
                                .alpha = *alpha_,
                                .layout = layout_,
                                .capacity = capacity,
                                .viewport = glm::vec2{size},
                                .half_width = half_width,
                                .runs = *runs_,
                                .run_capacity = run_capacity,
                                .record = *record_});
    }

    std::vector<Run> runs() {
        return read_back<Run>(*backend_, *runs_,
                              read_back<FrameRecord>(*backend_, *record_, 1)[0].points[0]);
    }

    std::vector<RunCuts> cuts() {
        const auto cuts = backend_->allocate(run_capacity * sizeof(RunCuts));
        backend_->halo({.table = table(),
                        .clipped = {*clipped_, *offsets_, *arcs_},
                        .runs = *runs_,
                        .record = *record_,
                        .run_capacity = run_capacity,
                        .viewport = glm::vec2{size},
                        .halo = halo,
                        .half_width = half_width,
                        .tolerance = tolerance,
                        .cuts = *cuts});
        return read_back<RunCuts>(*backend_, *cuts, runs().size());
    }

    std::vector<float> weights(float limit, glm::vec4 focus = {0, 0, 0, 0}, float far_limit = 1) {
        const glm::ivec2 cells = compute::density_cells(glm::vec2{size});
        const std::size_t count =
            LA_DENSITY_BINS * static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
        const auto weights = backend_->allocate(count * sizeof(float));
        backend_->density({.table = table(),
                           .clipped = {*clipped_, *offsets_, *arcs_},
                           .alpha = *alpha_,
                           .layout = layout_,
                           .runs = *runs_,
                           .record = *record_,
                           .run_capacity = run_capacity,
                           .viewport = glm::vec2{size},
                           .limit = limit,
                           .priority = {0.2F, 0.4F, 0.6F, 0.8F, 1},
                           .focus = focus,
                           .far_limit = far_limit,
                           .weights = *weights});
        return read_back<float>(*backend_, *weights, count);
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

    static constexpr std::uint32_t capacity = 1U << 16U, run_capacity = 1U << 12U;
    AtlasLayout layout_ = make_atlas_layout(AtlasLayoutKind::wrap, 401, 4096);
    std::unique_ptr<Backend> backend_;
    std::vector<glm::vec3> points_;
    std::vector<Segment> table_;
    std::unique_ptr<Buffer> vertices_, segments_, none_, clipped_, offsets_, arcs_, alpha_, runs_,
        record_;
};

std::size_t count_of(const RunCuts& cuts) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < LA_MOST_CUTS; ++k) count += cuts.from[k] != cuts.to[k] ? 1 : 0;
    return count;
}

std::size_t total_of(const std::vector<RunCuts>& cuts) {
    std::size_t count = 0;
    for (const RunCuts& of_run : cuts) count += count_of(of_run);
    return count;
}

class EffectsTest : public testing::TestWithParam<TestDevice> {
  protected:
    static Effects make(const Drawing& drawing) { return {GetParam().backend(), drawing}; }
};

/// Two straight lines through a point, the first horizontal; `shift` moves the point along it.
Drawing cross_at(float degrees, float depth_a, float depth_b, float shift = 0) {
    const float angle = degrees * std::numbers::pi_v<float> / 180;
    const glm::vec2 middle{160.3F, 120.7F};
    const glm::vec2 a{80, 0}, b = 70.0F * glm::vec2{std::cos(angle), std::sin(angle)};
    const glm::vec2 at = middle + glm::vec2{shift, 0};
    return {
        {{{middle - a, depth_a}, {middle + a, depth_a}}, {{at - b, depth_b}, {at + b, depth_b}}}};
}

void expect_gap(const RunCuts& cuts, float centre, float half_gap) {
    ASSERT_EQ(count_of(cuts), 1U);
    EXPECT_NEAR(cuts.from[0], centre - half_gap, 0.1F);
    EXPECT_NEAR(cuts.to[0], centre + half_gap, 0.1F);
}

TEST_P(EffectsTest, TheFartherOfTwoCrossingLinesGetsAGap) {
    for (const float degrees : {90.0F, 30.0F, 150.0F}) {
        SCOPED_TRACE(degrees);
        const float half_gap =
            (halo + half_width) / std::sin(degrees * std::numbers::pi_v<float> / 180);
        const std::vector<RunCuts> b_nearer = make(cross_at(degrees, 0.6F, 0.4F, 12.5F)).cuts();
        ASSERT_EQ(b_nearer.size(), 2U);
        expect_gap(b_nearer[0], 12.5F, half_gap); // arc length is 0 in the middle
        EXPECT_EQ(count_of(b_nearer[1]), 0U);
        const std::vector<RunCuts> a_nearer = make(cross_at(degrees, 0.4F, 0.6F, 12.5F)).cuts();
        EXPECT_EQ(count_of(a_nearer[0]), 0U);
        expect_gap(a_nearer[1], 0, half_gap);
    }
}

TEST_P(EffectsTest, AGapGrowsFromNothingWithTheAngle) {
    const auto gap_at = [](float sine) {
        const float degrees = std::asin(sine) * 180 / std::numbers::pi_v<float>;
        return make(cross_at(degrees, 0.6F, 0.4F)).cuts()[0];
    };
    expect_gap(gap_at(1.0F / 3), 0, 3 * (halo + half_width));
    expect_gap(gap_at(0.1F), 0, 0.9F * (halo + half_width));
    expect_gap(gap_at(0.02F), 0, 0.18F * (halo + half_width));
}

TEST_P(EffectsTest, EqualDepthLeavesNoGap) {
    EXPECT_EQ(total_of(make(cross_at(60, 0.5F, 0.5F)).cuts()), 0U);
    EXPECT_EQ(total_of(make(cross_at(60, 0.5F + 1.9F * tolerance, 0.5F)).cuts()), 0U);
    EXPECT_EQ(total_of(make(cross_at(60, 0.5F + 2.1F * tolerance, 0.5F)).cuts()), 1U);
}

TEST_P(EffectsTest, LinesThatMeetLeaveNoGap) {
    const glm::vec3 corner{150, 100, 0.5F};
    const Drawing star{
        {{{60, 100, 0.9F}, corner, {240, 110, 0.1F}}, {{150, 20, 0.2F}, corner, {140, 200, 0.8F}}}};
    EXPECT_EQ(total_of(make(star).cuts()), 0U);
}

TEST_P(EffectsTest, ALineThatEndsShortOfAnotherIsNotCut) {
    for (const float gap : {0.5F, 1.5F}) {
        const Drawing tee{
            {{{60, 100, 0.6F}, {240, 100, 0.6F}}, {{150, 100 + gap, 0.4F}, {150, 200, 0.4F}}}};
        EXPECT_EQ(total_of(make(tee).cuts()), gap < 1 ? 1U : 0U) << gap;
    }
}

TEST_P(EffectsTest, ALineBehindABoxKeepsClearOfIt) {
    const float near = 0.3F;
    Drawing box{
        {{{100, 80, near}, {220, 80, near}, {220, 160, near}, {100, 160, near}, {100, 80, near}},
         {{40, 120, 0.7F}, {280, 120, 0.7F}}}};
    box.add_rectangle({100, 80}, {220, 160}, near);
    Effects effects = make(box);
    const Runs runs = effects.runs();
    const std::vector<RunCuts> cuts = effects.cuts();
    ASSERT_EQ(runs.size(), 6U); // four edges, the line to the left and to the right
    for (std::size_t r = 0; r < 4; ++r) EXPECT_EQ(count_of(cuts[r]), 0U);
    EXPECT_EQ(runs[4].flags >> LA_RUN_END_SHIFT & LA_END_MASK, LA_END_HIDDEN);
    EXPECT_NE(runs[4].end[0], 100);
    expect_gap(cuts[4], 100 - 160, halo + half_width);
    expect_gap(cuts[5], 220 - 160, halo + half_width);
}

TEST_P(EffectsTest, TheFirstGapsAreKeptInOrder) {
    Drawing fence{{{{20, 100, 0.9F}, {300, 100, 0.9F}}}};
    for (int i = 11; i >= 0; --i) {
        const float x = 40 + 20 * static_cast<float>(i);
        fence.lines.push_back({{x, 50, 0.5F}, {x, 150, 0.5F}});
    }
    const RunCuts cuts = make(fence).cuts()[0];
    ASSERT_EQ(count_of(cuts), std::size_t{LA_MOST_CUTS});
    for (std::size_t k = 0; k < LA_MOST_CUTS; ++k) {
        EXPECT_NEAR(cuts.from[k] + cuts.to[k], 2 * (40 + 20 * static_cast<float>(k) - 160), 0.1F);
    }
}

/// All but silhouettes, which need faces; those that stay longest last.
constexpr std::array fan_kinds{LA_KIND_CREASE, LA_KIND_BOUNDARY, LA_KIND_MATERIAL, LA_KIND_FILE};

/// Twenty horizontal lines about y = 108, of kinds in turn; and one far from all others.
Drawing fan(float spacing, float shift = 0) {
    Drawing drawing;
    for (int i = 0; i < 20; ++i) {
        const float y = 108 + (static_cast<float>(i) - 9.5F) * spacing + shift;
        drawing.lines.push_back({{60.2F + shift, y, 0.5F}, {260.2F + shift, y, 0.5F}});
        drawing.kinds.push_back(fan_kinds[static_cast<std::size_t>(i) % fan_kinds.size()]);
    }
    drawing.lines.push_back({{30, 20, 0.5F}, {150, 20, 0.5F}});
    drawing.kinds.push_back(LA_KIND_CREASE);
    return drawing;
}

/// What a line's opacity is multiplied with at a place: between four cells and two bins.
float weight_at(const std::vector<float>& weights, const Run& run, glm::vec2 place) {
    const glm::ivec2 cells = compute::density_cells(glm::vec2{size});
    const glm::vec2 at = place / float{LA_DENSITY_CELL} - 0.5F;
    const glm::ivec2 low{glm::floor(at)};
    const glm::vec2 up = at - glm::vec2{low};
    const auto of_bin = [&](std::uint32_t bin) {
        const auto of_cell = [&](int x, int y) {
            x = std::clamp(x, 0, cells.x - 1);
            y = std::clamp(y, 0, cells.y - 1);
            return weights[static_cast<std::size_t>(
                (static_cast<int>(bin) * cells.y + y) * cells.x + x)];
        };
        return std::lerp(std::lerp(of_cell(low.x, low.y), of_cell(low.x + 1, low.y), up.x),
                         std::lerp(of_cell(low.x, low.y + 1), of_cell(low.x + 1, low.y + 1), up.x),
                         up.y);
    };
    const std::uint32_t priority = run.flags >> LA_RUN_BIN_SHIFT & LA_RUN_BIN_MASK;
    const std::uint32_t bin = priority / LA_BIN_STEPS;
    if (bin + 1 == LA_DENSITY_BINS) return of_bin(bin);
    const float share = static_cast<float>(priority % LA_BIN_STEPS) / float{LA_BIN_STEPS};
    return std::lerp(of_bin(bin), of_bin(bin + 1), share);
}

/// Pixels of line per pixel about (164, 108), averaged as the stage does it: with a tent over five
/// cells, of which each takes part in the lines around it.
float density_of_fan(const Runs& runs, const std::vector<float>* weights) {
    float sum = 0;
    for (std::size_t r = 0; r < 20; ++r) {
        const float y = runs[r].start[1];
        const float opacity = weights != nullptr ? weight_at(*weights, runs[r], {164, y}) : 1;
        for (int k = -2; k <= 2; ++k) {
            const float away = (y - 108) / LA_DENSITY_CELL - static_cast<float>(k);
            const float tent = static_cast<float>(3 - std::abs(k)) / 9;
            sum += opacity * tent * std::max(0.0F, 1 - std::fabs(away)) / LA_DENSITY_CELL;
        }
    }
    return sum;
}

TEST_P(EffectsTest, TheLimitIsKeptWhereLinesAreDense) {
    for (const float spacing : {0.1F, 0.4F, 1.0F, 2.0F, 5.0F}) {
        // The edges of narrow heaps, where there are fewer lines, take part in their middle.
        const float most = spacing < 5 ? 1.08F : 1.05F;
        Effects effects = make(fan(spacing));
        for (const float share : {0.25F, 0.5F, 0.75F}) {
            SCOPED_TRACE(testing::Message() << spacing << " " << share);
            const float before = density_of_fan(effects.runs(), nullptr);
            const std::vector<float> weights = effects.weights(share * before);
            const float after = density_of_fan(effects.runs(), &weights);
            EXPECT_LE(after, most * share * before);
            EXPECT_GE(after, 0.85F * share * before);
        }
    }
}

TEST_P(EffectsTest, MoreImportantLinesStay) {
    Effects effects = make(fan(1));
    const std::vector<float> weights = effects.weights(0.3F);
    const Runs runs = effects.runs();
    std::array<float, fan_kinds.size()> of_kind{};
    for (std::size_t r = 0; r < 20; ++r) {
        of_kind[r % fan_kinds.size()] += 0.2F * weight_at(weights, runs[r], {164, 108});
    }
    EXPECT_TRUE(std::ranges::is_sorted(of_kind));
    EXPECT_LT(of_kind.front(), 0.01F);
    EXPECT_GT(of_kind.back(), 0.9F);
    // Alone where it is, a line stays as it is.
    EXPECT_EQ(weight_at(weights, runs[20], {90, 20}), 1);
}

TEST_P(EffectsTest, LongerLinesStay) {
    Drawing drawing;
    drawing.kinds.assign(2, LA_KIND_CREASE);
    drawing.lines = {{{150, 100, 0.5F}, {158, 100, 0.5F}}, {{20, 110, 0.5F}, {300, 110, 0.5F}}};
    Effects effects = make(drawing);
    effects.weights(0.1F);
    const Runs runs = effects.runs();
    EXPECT_GT(runs[1].flags >> LA_RUN_BIN_SHIFT, runs[0].flags >> LA_RUN_BIN_SHIFT);
}

TEST_P(EffectsTest, TheFocusChangesTheLimit) {
    Effects effects = make(fan(1));
    const std::vector<float> plain = effects.weights(0.3F);
    const glm::vec4 focus{80, 110, 30, 60};
    const std::vector<float> focused = effects.weights(0.3F, focus, 0.25F);
    const std::vector<float> lower = effects.weights(0.3F * 0.25F);
    const Runs runs = effects.runs();
    for (const auto& run : runs) {
        EXPECT_EQ(weight_at(focused, run, {80, 108}), weight_at(plain, run, {80, 108}));
        EXPECT_NEAR(weight_at(focused, run, {230, 108}), weight_at(lower, run, {230, 108}), 1e-5F);
    }
}

TEST_P(EffectsTest, WeightsChangeSmoothly) {
    const auto at = [&](float shift) {
        Effects effects = make(fan(1, shift));
        const std::vector<float> weights = effects.weights(0.3F);
        std::vector<float> result;
        const Runs runs = effects.runs();
        for (std::size_t r = 0; r < 20; ++r) {
            for (float x = 65; x < 255; x += 10) {
                result.push_back(weight_at(weights, runs[r], {x + shift, runs[r].start[1]}));
            }
        }
        return result;
    };
    std::vector<float> last = at(0);
    float largest = 0;
    for (float shift = 0.5F; shift <= 8; shift += 0.5F) {
        const std::vector<float> next = at(shift);
        for (std::size_t i = 0; i < next.size(); ++i) {
            largest = std::max(largest, std::fabs(next[i] - last[i]));
        }
        last = next;
    }
    EXPECT_LE(largest, 0.1F);
}

/// The plain C++ as one more device.
std::vector<TestDevice> all_devices() {
    std::vector<TestDevice> result = test_devices();
    result.push_back(
        {"reference", [](std::size_t) { return compute::make_reference_backend(); }, 0});
    return result;
}

INSTANTIATE_TEST_SUITE_P(OnDevice, EffectsTest, testing::ValuesIn(all_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
