// The figures of intervals find planted errors.

#include "interval_errors.hpp"

#include <gtest/gtest.h>

namespace lineatlas::bench {
namespace {

/// One path of two segments, 100 and 50 pixels long from left to right; visible from 20 to 120.
class IntervalErrorsTest : public testing::Test {
  protected:
    IntervalErrorsTest() {
        lines_.segments = {{.p = 0,
                            .q = 1,
                            .face_a = LA_NO_FACE,
                            .face_b = LA_NO_FACE,
                            .from_start = 0,
                            .to_end = 1,
                            .path = 0,
                            .tag = 0},
                           {.p = 1,
                            .q = 2,
                            .face_a = LA_NO_FACE,
                            .face_b = LA_NO_FACE,
                            .from_start = 1,
                            .to_end = 0,
                            .path = 0,
                            .tag = 0}};
        const auto clipped = [](float from, float to) {
            return ClippedSegment{.p = {from / 100 - 1, 0, 0, 1},
                                  .q = {to / 100 - 1, 0, 0, 1},
                                  .t0 = 0,
                                  .t1 = 1,
                                  .own_a = 0,
                                  .own_b = 0};
        };
        fine_.clipped = {clipped(0, 100), clipped(100, 150)};
        fine_.offsets = {0, 400, 600};
        for (int j = 0; j < 600; ++j) truth_.push_back(j >= 80 && j < 480 ? 1.0F : 0.0F);
    }

    IntervalFigures compare(const std::vector<Interval>& intervals) const {
        return compare_intervals(lines_, fine_, {200, 200}, truth_, intervals);
    }

    /// Makes an interval of a segment with samples of 2 pixels.
    static Interval piece(std::uint32_t segment, float from, float to, bool visible) {
        Interval interval{};
        interval.segment = segment;
        interval.start_sample = from / 2;
        interval.end_sample = to / 2;
        interval.flags = visible ? LA_INTERVAL_VISIBLE : 0;
        return interval;
    }

    LineSet lines_;
    ClippedLines fine_;
    std::vector<float> truth_;
};

TEST_F(IntervalErrorsTest, NothingIsWrongWithTheTruth) {
    const IntervalFigures figures = compare({piece(0, 0, 20, false), piece(0, 20, 100, true),
                                             piece(1, 0, 20, true), piece(1, 20, 50, false)});
    EXPECT_NEAR(figures.length, 150, 1e-3);
    EXPECT_NEAR(figures.visible, 100, 1e-3);
    EXPECT_NEAR(figures.truly_visible, 100, 1e-3);
    EXPECT_NEAR(figures.falsely_visible + figures.falsely_hidden + figures.missing, 0, 1e-3);
    EXPECT_EQ(figures.ends, 2U);
    EXPECT_EQ(figures.ends_within(0.01), 1);
    EXPECT_EQ(figures.crumbs, 0U);
}

TEST_F(IntervalErrorsTest, SeesEndsThatAreOff) {
    const IntervalFigures figures = compare({piece(0, 0, 20.5F, false), piece(0, 20.5F, 100, true),
                                             piece(1, 0, 21, true), piece(1, 21, 50, false)});
    EXPECT_NEAR(figures.falsely_hidden, 0.5, 1e-3);
    EXPECT_NEAR(figures.falsely_visible, 1, 1e-3);
    EXPECT_NEAR(figures.visible, 100.5, 1e-3);
    EXPECT_EQ(figures.ends_within(0.4), 0);
    EXPECT_EQ(figures.ends_within(0.6), 0.5);
    EXPECT_EQ(figures.ends_within(1.1), 1);
}

TEST_F(IntervalErrorsTest, SeesCrumbsAndWhatIsMissing) {
    const IntervalFigures figures =
        compare({piece(0, 0, 5, false), piece(0, 5, 5.8F, true), piece(0, 5.8F, 20, false),
                 piece(0, 20, 90, true), piece(1, 0, 20, true), piece(1, 20, 50, false)});
    EXPECT_EQ(figures.crumbs, 1U);
    EXPECT_NEAR(figures.missing, 0,
                1e-3); // lengths are shares of the length that a segment's intervals span
    const IntervalFigures without = compare({piece(1, 0, 20, true), piece(1, 20, 50, false)});
    EXPECT_NEAR(without.missing, 100, 1e-3);
}

} // namespace
} // namespace lineatlas::bench
