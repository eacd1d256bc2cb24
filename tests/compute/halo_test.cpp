// halo: known answers on hand-made drawings.

#include "effects_support.hpp"

namespace lineatlas::test {
namespace {

class HaloStage : public EffectsTest {};

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

TEST_P(HaloStage, TheFartherOfTwoCrossingLinesGetsAGap) {
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

TEST_P(HaloStage, AGapGrowsFromNothingWithTheAngle) {
    const auto gap_at = [](float sine) {
        const float degrees = std::asin(sine) * 180 / std::numbers::pi_v<float>;
        return make(cross_at(degrees, 0.6F, 0.4F)).cuts()[0];
    };
    expect_gap(gap_at(1.0F / 3), 0, 3 * (halo + half_width));
    expect_gap(gap_at(0.1F), 0, 0.9F * (halo + half_width));
    expect_gap(gap_at(0.02F), 0, 0.18F * (halo + half_width));
}

TEST_P(HaloStage, EqualDepthLeavesNoGap) {
    EXPECT_EQ(total_of(make(cross_at(60, 0.5F, 0.5F)).cuts()), 0U);
    EXPECT_EQ(total_of(make(cross_at(60, 0.5F + 1.9F * tolerance, 0.5F)).cuts()), 0U);
    EXPECT_EQ(total_of(make(cross_at(60, 0.5F + 2.1F * tolerance, 0.5F)).cuts()), 1U);
}

TEST_P(HaloStage, LinesThatMeetLeaveNoGap) {
    const glm::vec3 corner{150, 100, 0.5F};
    const Drawing star{
        {{{60, 100, 0.9F}, corner, {240, 110, 0.1F}}, {{150, 20, 0.2F}, corner, {140, 200, 0.8F}}}};
    EXPECT_EQ(total_of(make(star).cuts()), 0U);
}

TEST_P(HaloStage, ALineThatEndsShortOfAnotherIsNotCut) {
    for (const float gap : {0.5F, 1.5F}) {
        const Drawing tee{
            {{{60, 100, 0.6F}, {240, 100, 0.6F}}, {{150, 100 + gap, 0.4F}, {150, 200, 0.4F}}}};
        EXPECT_EQ(total_of(make(tee).cuts()), gap < 1 ? 1U : 0U) << gap;
    }
}

TEST_P(HaloStage, ALineBehindABoxKeepsClearOfIt) {
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

TEST_P(HaloStage, TheFirstGapsAreKeptInOrder) {
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

INSTANTIATE_TEST_SUITE_P(OnDevice, HaloStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
