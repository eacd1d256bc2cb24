// compact: makes runs of given samples, with all that strokes need.

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

using Runs = std::vector<Run>; // testing::Test has a Run of its own

class CompactStage : public StageTest {
  protected:
    struct Options {
        bool hidden = false;
        std::uint32_t run_capacity = 64;
        std::uint32_t capacity = 4096; ///< samples
        float half_width = 1;
    };
    /// alpha: of the texels of the atlas.
    Runs compact(const std::vector<HandLine>& lines, const std::vector<std::uint8_t>& alpha,
                 const Options& options) {
        HandFrame frame{device(), lines};
        const auto vertices = device().allocate(16);
        const auto texels = put(alpha);
        const auto runs = put(Runs(64));
        const auto record = device().allocate(sizeof(FrameRecord));
        stages().compact({.table = frame.table(*vertices),
                          .atlas = {frame.clipped(), *texels, options.capacity},
                          .viewport = glm::vec2{hand_size},
                          .half_width = options.half_width,
                          .hidden = options.hidden,
                          .runs = {*runs, *record, options.run_capacity}});
        record_ = get<FrameRecord>(*record, 1)[0];
        EXPECT_EQ(record_.sample_total, frame.samples());
        return get<lineatlas::Run>(*runs, record_.points[0]);
    }
    Runs compact(const std::vector<HandLine>& lines, const std::vector<std::uint8_t>& alpha) {
        return compact(lines, alpha, Options{});
    }

    FrameRecord record_{};
};
INSTANTIATE_TEST_SUITE_P(OnDevice, CompactStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

/// From pixel 8 to 40 in 16 samples, from depth 0.25 to 0.75.
HandLine level(std::uint32_t from_start = 0, std::uint32_t to_end = 0, std::uint32_t tag = 0) {
    return {.p = {8, 20, 0.25F, 1},
            .q = {40, 20, 0.75F, 1},
            .samples = 16,
            .from_start = from_start,
            .to_end = to_end,
            .tag = tag};
}

std::uint32_t start_of(const lineatlas::Run& run) {
    return run.flags >> LA_RUN_START_SHIFT & LA_END_MASK;
}
std::uint32_t end_of(const lineatlas::Run& run) {
    return run.flags >> LA_RUN_END_SHIFT & LA_END_MASK;
}

TEST_P(CompactStage, ARunIsARowOfSamplesThatAreNotHiddenWhole) {
    const Runs runs = compact({level(0, 0, LA_KIND_BOUNDARY)},
                              {0, 0, 0, 1, 255, 7, 0, 0, 90, 0, 0, 0, 0, 0, 0, 0});
    ASSERT_EQ(runs.size(), 2U);
    const std::uint32_t hidden_ends =
        LA_END_HIDDEN << LA_RUN_START_SHIFT | LA_END_HIDDEN << LA_RUN_END_SHIFT |
        LA_END_HIDDEN << LA_STROKE_START_SHIFT | LA_END_HIDDEN << LA_STROKE_END_SHIFT;
    // The run is half a sample longer at either end. A sample is two pixels and 1/32 of depth.
    const lineatlas::Run expected{.start = {13, 20},
                                  .end = {21, 20},
                                  .start_corner = {0, 0},
                                  .end_corner = {0, 0},
                                  .start_arc = -11, // 0 in the middle of the path, at pixel 24
                                  .end_arc = -3,
                                  .start_sample = 2.5F,
                                  .end_sample = 6.5F,
                                  .address = 0,
                                  .samples = 16,
                                  .flags = hidden_ends,
                                  .segment = 0,
                                  .stroke_start = -11,
                                  .stroke_end = -3,
                                  .start_depth = 0.25F + 2.5F / 32,
                                  .end_depth = 0.25F + 6.5F / 32};
    EXPECT_TRUE(close(runs[0], expected));
    EXPECT_FLOAT_EQ(runs[1].start[0], 23);
    EXPECT_FLOAT_EQ(runs[1].end[0], 27);
    const FrameRecord& record = record_;
    EXPECT_TRUE(equal<std::uint32_t>({record.points, record.points + 4}, {2, 1, 0, 0}));
    EXPECT_EQ(record.run_total, 2U);
    EXPECT_EQ(record.raw_run_total, 2U);
}

TEST_P(CompactStage, AtTheEndsOfItsSegmentARunEndsThere) {
    std::vector<std::uint8_t> alpha(16, 255);
    const Runs whole = compact({level()}, alpha);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].start_sample, 0);
    EXPECT_EQ(whole[0].end_sample, 16);
    EXPECT_EQ(start_of(whole[0]), LA_END_PATH);
    EXPECT_EQ(end_of(whole[0]), LA_END_PATH);
    HandLine cut = level();
    cut.t0 = 0.25F;
    cut.t1 = 0.5F;
    const Runs clipped = compact({cut}, alpha);
    EXPECT_EQ(start_of(clipped.at(0)), LA_END_CLIPPED);
    EXPECT_EQ(end_of(clipped.at(0)), LA_END_CLIPPED);
}

TEST_P(CompactStage, HiddenOnesAreTheRest) {
    std::vector<HandLine> lines{level(), level(), level(0, 1), level(1, 0)};
    lines[1].samples = 0;                                      // dropped as hidden whole
    lines.push_back({{8, 9, 0.5F, 1}, {8.5F, 9, 0.5F, 1}, 1}); // the thickness of a board
    std::vector<std::uint8_t> alpha(64, 255);
    alpha[5] = alpha[6] = 0;
    alpha[48] = 0; // of the last
    const Runs runs = compact(lines, alpha, {.hidden = true});
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].start_sample, 4.5F);
    EXPECT_EQ(runs[0].end_sample, 7.5F);
    EXPECT_EQ(runs[1].segment, 1U);
    EXPECT_EQ(runs[1].samples, 1U);
    EXPECT_NE(runs[1].flags & LA_RUN_SOLID, 0U);
    EXPECT_FLOAT_EQ(runs[1].start[0], 8);
    EXPECT_FLOAT_EQ(runs[1].end[0], 40);
    EXPECT_EQ(compact(lines, alpha).size(), 4U) << "visible ones: two, none, one and one";
}

/// Three sides of a square, or of a narrow bend.
std::vector<HandLine> path(glm::vec2 a, glm::vec2 b, glm::vec2 c, std::uint32_t flags = 0) {
    const auto place = [](glm::vec2 at) { return WindowPlace{at.x, at.y, 0.5F, 1}; };
    return {{place(a), place(b), 4, 0, 1, LA_KIND_CREASE | flags},
            {place(b), place(c), 4, 1, 0, LA_KIND_CREASE | flags}};
}

TEST_P(CompactStage, SegmentsOfAPathMeetOnTheirBisector) {
    const std::vector<std::uint8_t> alpha(8, 255);
    const Runs corner = compact(path({10, 10}, {30, 10}, {30, 40}), alpha);
    ASSERT_EQ(corner.size(), 2U);
    EXPECT_EQ(end_of(corner[0]), LA_END_JOIN);
    EXPECT_EQ(start_of(corner[1]), LA_END_JOIN);
    // Left edges, at y 11 and at x 29, cross one to the left and one up.
    for (const float* at : {corner[0].end_corner, corner[1].start_corner}) {
        EXPECT_FLOAT_EQ(at[0], -1);
        EXPECT_FLOAT_EQ(at[1], 1);
    }
    // Arc length runs on: 20 and 30 pixels, 0 in the middle of both.
    EXPECT_FLOAT_EQ(corner[0].start_arc, -25);
    EXPECT_FLOAT_EQ(corner[0].end_arc, -5);
    EXPECT_FLOAT_EQ(corner[1].start_arc, -5);
    EXPECT_FLOAT_EQ(corner[1].end_arc, 25);
    EXPECT_EQ(corner[1].address, 4U);

    // Turned by 45 degrees: the corner is 1 / cos(22.5) long, at a right angle to the mean.
    const Runs bent = compact(path({10, 10}, {30, 10}, {40, 20}), alpha);
    EXPECT_NEAR(bent[0].end_corner[0], -std::tan(std::atan(1.0) / 2), 1e-5);
    EXPECT_NEAR(bent[0].end_corner[1], 1, 1e-5);
}

TEST_P(CompactStage, SharpTurnsAndShortSegmentsHaveRoundEnds) {
    const std::vector<std::uint8_t> alpha(8, 255);
    const auto join_of = [&](glm::vec2 c, float half_width) {
        return end_of(
            compact(path({10, 10}, {30, 10}, c), alpha, {.half_width = half_width}).at(0));
    };
    EXPECT_EQ(join_of({13, 21}, 1), LA_END_JOIN);  // turned by 147 degrees
    EXPECT_EQ(join_of({12, 20}, 1), LA_END_ROUND); // by 151
    // A quarter turn takes as much of either as half the stroke's width.
    EXPECT_EQ(join_of({30, 14}, 3.9F), LA_END_JOIN);
    EXPECT_EQ(join_of({30, 14}, 4.1F), LA_END_ROUND);
}

TEST_P(CompactStage, LoopsGoOnInTheirFirstSegment) {
    std::vector<HandLine> loop = path({10, 10}, {30, 10}, {30, 40}, LA_TAG_CLOSED);
    const std::vector<std::uint8_t> alpha(8, 255);
    const Runs runs = compact(loop, alpha);
    EXPECT_EQ(start_of(runs.at(0)), LA_END_JOIN);
    EXPECT_EQ(end_of(runs.at(1)), LA_END_JOIN);
    loop[0].t0 = 0.5F;
    EXPECT_EQ(start_of(compact(loop, alpha).at(0)), LA_END_CLIPPED);
    EXPECT_EQ(end_of(compact(loop, alpha).at(1)), LA_END_JOIN);
}

TEST_P(CompactStage, TablesThatAreTooSmallAreReported) {
    const std::vector<HandLine> lines{level(), level()};
    std::vector<std::uint8_t> alpha(32, 255);
    alpha[3] = alpha[9] = 0;
    EXPECT_TRUE(compact(lines, alpha, {.run_capacity = 3}).empty());
    EXPECT_EQ(record_.run_total, 4U);
    EXPECT_EQ(compact(lines, alpha, {.run_capacity = 4}).size(), 4U);
    // Without room for the second segment's last sample it has no runs.
    EXPECT_EQ(compact(lines, alpha, {.capacity = 31}).size(), 3U);
}

TEST_P(CompactStage, SamplesAreThoseOfTheirSegment) {
    std::vector<std::uint8_t> alpha(64, 0);
    alpha[16] = 255;
    const Runs runs = compact({level(), level()}, alpha);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].segment, 1U);
    EXPECT_EQ(runs[0].address, 16U);
    EXPECT_EQ(runs[0].end_sample, 1.5F);
}

} // namespace
} // namespace lineatlas::test
