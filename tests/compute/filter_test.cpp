// filter: known answers on one line that passes behind walls.

#include "effects_support.hpp"

namespace lineatlas::test {
namespace {

/// From one end of a run to the other, in pixels along the line.
struct Extent {
    float from, to;
};

/// A line from x = 40 to 280 behind walls that hide it in [100, 120] and [140, 200]. The visible
/// parts are 60, 20 and 80 pixels long, with holes of 20 and 60 between them.
Drawing fenced_line() {
    Drawing drawing{{{{40, 120.5F, 0.5F}, {280, 120.5F, 0.5F}}}};
    drawing.add_rectangle({100, 80}, {120, 160}, 0.2F);
    drawing.add_rectangle({140, 80}, {200, 160}, 0.2F);
    return drawing;
}

class FilterStage : public EffectsTest {
  protected:
    static void expect(const StrokeFilter& filter, const std::vector<Extent>& expected) {
        constexpr float close = 2; // a sample, the precision of visibility by `atlas`
        const Runs runs = make(fenced_line()).filtered(filter);
        ASSERT_EQ(runs.size(), expected.size());
        for (std::size_t i = 0; i < runs.size(); ++i) {
            EXPECT_NEAR(runs[i].start[0], expected[i].from, close) << i;
            EXPECT_NEAR(runs[i].end[0], expected[i].to, close) << i;
        }
    }
};

TEST_P(FilterStage, NothingToDoLeavesAllAsItWas) {
    expect({}, {{40, 100}, {120, 140}, {200, 280}});
}

TEST_P(FilterStage, HolesShorterThanFillAreClosed) {
    expect({.fill_holes = 17}, {{40, 100}, {120, 140}, {200, 280}});
    expect({.fill_holes = 23}, {{40, 140}, {200, 280}});
    expect({.fill_holes = 63}, {{40, 280}});
}

TEST_P(FilterStage, RunsShorterThanDropAreLeftOut) {
    expect({.drop_runs = 17}, {{40, 100}, {120, 140}, {200, 280}});
    expect({.drop_runs = 23}, {{40, 100}, {200, 280}});
    expect({.drop_runs = 63}, {{200, 280}});
}

TEST_P(FilterStage, HolesAreClosedBeforeRunsAreLeftOut) {
    expect({.fill_holes = 23, .drop_runs = 83}, {{40, 140}});
}

TEST_P(FilterStage, OvershootGoesBeyondEitherEnd) {
    expect({.overshoot = 5}, {{35, 105}, {115, 145}, {195, 285}});
}

TEST_P(FilterStage, OvershootsThatMeetCloseAHole) {
    expect({.overshoot = 14}, {{26, 154}, {186, 294}});
}

TEST_P(FilterStage, UndershootStopsBeforeWhatHidesTheLine) {
    expect({.undershoot = 6}, {{40, 94}, {126, 134}, {206, 280}});
}

TEST_P(FilterStage, OvershootVariesByItsShareAtMost) {
    const Runs runs = make(fenced_line()).filtered({.overshoot = 20, .overshoot_variation = 0.5F});
    ASSERT_FALSE(runs.empty());
    EXPECT_GE(runs.front().start[0], 40 - 20 - 0.01F);
    EXPECT_LE(runs.front().start[0], 40 - 10 + 0.01F);
    EXPECT_NEAR(runs.back().end[0] - 280, 40 - runs.front().start[0], 0.01F);
}

INSTANTIATE_TEST_SUITE_P(OnDevice, FilterStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
