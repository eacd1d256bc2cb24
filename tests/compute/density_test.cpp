// density: known answers on hand-made drawings.

#include "effects_support.hpp"

namespace lineatlas::test {
namespace {

class DensityStage : public EffectsTest {};

/// All kinds except silhouettes, which need faces. Kinds that stay longest come last.
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

/// The factor of a line's opacity at a place, interpolated between four cells and two bins.
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

/// Pixels of line per pixel about (164, 108). They are averaged as by the stage, with a tent over
/// five cells. Each line counts in the cells around it.
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

TEST_P(DensityStage, TheLimitIsKeptWhereLinesAreDense) {
    for (const float spacing : {0.1F, 0.4F, 1.0F, 2.0F, 5.0F}) {
        // The edges of narrow heaps have fewer lines, and count in the heaps' middle.
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

TEST_P(DensityStage, MoreImportantLinesStay) {
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
    // A line far from others stays as it is.
    EXPECT_EQ(weight_at(weights, runs[20], {90, 20}), 1);
}

TEST_P(DensityStage, LongerLinesStay) {
    Drawing drawing;
    drawing.kinds.assign(2, LA_KIND_CREASE);
    drawing.lines = {{{150, 100, 0.5F}, {158, 100, 0.5F}}, {{20, 110, 0.5F}, {300, 110, 0.5F}}};
    Effects effects = make(drawing);
    effects.weights(0.1F);
    const Runs runs = effects.runs();
    EXPECT_GT(runs[1].flags >> LA_RUN_BIN_SHIFT, runs[0].flags >> LA_RUN_BIN_SHIFT);
}

TEST_P(DensityStage, TheFocusChangesTheLimit) {
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

TEST_P(DensityStage, WeightsChangeSmoothly) {
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

INSTANTIATE_TEST_SUITE_P(OnDevice, DensityStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
