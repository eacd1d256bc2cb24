// temporal: averages samples with those at the same place of the line in the frame before.

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

struct Frame {
    std::vector<HandLine> lines;
    std::vector<std::uint8_t> alpha; ///< of all samples, one after the other
};

/// A line with `samples` samples between two clip parameters.
HandLine line(std::uint32_t samples, float t0 = 0, float t1 = 1, float wp = 1, float wq = 1) {
    return {.p = {0, 20, 0.5F, wp},
            .q = {2 * static_cast<float>(samples), 20, 0.5F, wq},
            .samples = samples,
            .t0 = t0,
            .t1 = t1};
}

class TemporalStage : public StageTest {
  protected:
    /// The samples of the last frame, after each frame was averaged with the one before.
    std::vector<std::uint8_t> averaged(const std::vector<Frame>& frames, bool forget = false) {
        const auto n = frames[0].lines.size();
        const auto history_alpha = put(std::vector<std::uint8_t>(64));
        const auto history_offsets = put(std::vector<std::uint32_t>(n + 1));
        const auto ranges = put(std::vector<std::uint32_t>(n));
        std::vector<std::uint8_t> result;
        for (const Frame& frame : frames) {
            HandFrame tables{device(), frame.lines};
            std::vector<std::uint8_t> padded = frame.alpha;
            padded.resize(64);
            const auto alpha = put(padded);
            const bool is_first = &frame == frames.data();
            stages().temporal({.segment_count = tables.count(),
                               .atlas = {tables.clipped(), *alpha, 64},
                               .history = {*history_alpha, *history_offsets, *ranges},
                               .use = !is_first && !forget ? LA_HISTORY_CAMERA : LA_HISTORY_NONE});
            result = get<std::uint8_t>(*alpha, frame.alpha.size());
            EXPECT_TRUE(equal(get<std::uint8_t>(*history_alpha, frame.alpha.size()), result));
            EXPECT_TRUE(equal(get<std::uint32_t>(*history_offsets, n + 1),
                              get<std::uint32_t>(tables.clipped().offsets, n + 1)));
        }
        return result;
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, TemporalStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST_P(TemporalStage, AMovingAverageTakes22HundredthsOfTheNewFrame) {
    //                                         up    down  same  small at either extreme  large
    const Frame before{{line(10)}, {100, 200, 120, 245, 10, 240, 80, 205, 0, 255}};
    const Frame now{{line(10)}, {200, 100, 120, 255, 0, 230, 255, 100, 100, 155}};
    EXPECT_TRUE(equal(averaged({before, now}), {122, 178, 120, 255, 0, 238, 255, 182, 22, 233}));
    EXPECT_TRUE(equal(averaged({before, now}, true), now.alpha)) << "without a frame before";
}

TEST_P(TemporalStage, ChangesOfMoreThan170AreNoChance) {
    const Frame before{{line(4)}, {50, 50, 250, 250}};
    EXPECT_TRUE(equal(averaged({before, {{line(4)}, {220, 221, 80, 79}}}), {87, 221, 213, 79}));
}

TEST_P(TemporalStage, EachFrameIsAveragedWithTheAverage) {
    const Frame dark{{line(1)}, {100}}, light{{line(1)}, {200}};
    EXPECT_TRUE(equal(averaged({dark, light}), {122}));
    EXPECT_TRUE(equal(averaged({dark, light, light}), {139})); // 122 + 78 * 0.22 = 139.16
}

TEST_P(TemporalStage, SamplesAreFoundByTheirPlaceOnTheLine) {
    // Half of the line is left with as many samples as that half had before. Sample j was sample 4
    // + j.
    const Frame before{{line(8)}, {0, 0, 0, 0, 100, 150, 200, 50}};
    const Frame half{{line(4, 0.5F, 1)}, {140, 110, 240, 90}};
    EXPECT_TRUE(equal(averaged({before, half}), {109, 141, 209, 59}));
    // Parts that were outside the picture before are not averaged.
    const Frame later{{line(4, 0.5F, 1)}, {100, 100, 100, 100}};
    const Frame whole{{line(8)}, {60, 60, 60, 60, 60, 60, 60, 60}};
    EXPECT_TRUE(equal(averaged({later, whole}), {60, 60, 60, 60, 91, 91, 91, 91}));
}

TEST_P(TemporalStage, BetweenTwoSamplesTheirMeanCounts) {
    // Before there were twice as many samples, in any perspective. Sample j lay between 2 j and 2 j
    // + 1.
    for (const auto& [wp, wq] : {std::pair{1.0F, 1.0F}, {1.0F, 4.0F}, {3.0F, 0.5F}}) {
        const Frame before{{line(6, 0, 1, wp, wq)}, {90, 110, 140, 160, 200, 220}};
        const Frame now{{line(3, 0, 1, wp, wq)}, {60, 110, 250}};
        EXPECT_TRUE(equal(averaged({before, now}), {91, 141, 219})) << wp << " " << wq;
    }
}

TEST_P(TemporalStage, PerspectiveDecidesWhatLiesWhere) {
    // In both frames the visible part goes from w = 1 to w = 3. Before, it was the whole line; now
    // it is the first half. A sample is at the share u on the screen and s of the line, and was at
    // v.
    std::vector<std::uint8_t> ramp;
    for (int i = 0; i < 16; ++i) ramp.push_back(static_cast<std::uint8_t>(60 + 8 * i));
    const Frame before{{line(16, 0, 1, 1, 3)}, ramp};
    const Frame now{{line(4, 0, 0.5F, 1, 3)}, {100, 100, 100, 100}};
    std::vector<std::uint8_t> expected;
    for (int j = 0; j < 4; ++j) {
        const double u = (j + 0.5) / 4;
        // The place (1 - f) p + f q in space is at the share u on the screen with 3 f : (1 - f) = u
        // : (1 - u).
        const double s = u / (u + 3 * (1 - u)) * 0.5;
        const double v = 3 * s / (3 * s + 1 - s);
        const double past = 60 + 8 * (v * 16 - 0.5);
        expected.push_back(static_cast<std::uint8_t>(past + (100 - past) * 0.22 + 0.5));
    }
    EXPECT_TRUE(equal(averaged({before, now}), expected));
}

TEST_P(TemporalStage, EverySegmentHasItsOwnPast) {
    const Frame before{{line(2), line(0), line(3)}, {10, 20, 30, 40, 50}};
    const Frame now{{line(2), line(2), line(3)}, {50, 60, 80, 90, 70, 80, 90}};
    EXPECT_TRUE(equal(averaged({before, now}), {19, 29, 80, 90, 39, 49, 59}));
}

} // namespace
} // namespace lineatlas::test
