// Sparkle and crawl on lines whose figures are known by hand.

#include "motion.hpp"

#include <gtest/gtest.h>

#include "burst.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::ivec2 viewport{400, 400};

/// One segment of `l` samples over the middle half of the viewport, 200 pixels, moved by `shift`
/// pixels.
ClippedLines line(std::uint32_t l, float shift = 0) {
    ClippedSegment segment{};
    segment.p[0] = -0.5F + shift / 200;
    segment.q[0] = 0.5F + shift / 200;
    segment.p[3] = segment.q[3] = 1;
    segment.t1 = 1;
    return {{segment}, {0, l}};
}

LineSet one_segment() {
    LineSet lines;
    lines.segments.push_back({});
    return lines;
}

/// A stroke over part of the segment, with a texture that is `shift` pixels off.
Run stroke(float from, float to, float shift = 0) {
    Run run{};
    run.start_sample = from;
    run.end_sample = to;
    run.start_arc = 2 * from - 100 + shift;
    run.end_arc = 2 * to - 100 + shift;
    return run;
}

/// `l` samples, of which the first `count` are visible.
template <class T>
std::vector<T> step(std::uint32_t count, std::uint32_t l, T one) {
    std::vector<T> samples(l, T{0});
    std::fill_n(samples.begin(), count, one);
    return samples;
}

std::vector<std::uint8_t> alpha_step(std::uint32_t count) {
    return step<std::uint8_t>(count, 100, 255);
}
std::vector<float> truth_step(std::uint32_t count) {
    return step<float>(count, 100, 1);
}

struct Frame {
    ClippedLines clipped = line(100);
    std::vector<std::uint8_t> alpha = alpha_step(50);
    std::vector<float> truth = truth_step(50);
    std::vector<Run> runs = {stroke(0, 50)};
};

MotionFigures compare(const Frame& now, const Frame& before) {
    const StrokeArcs arcs{now.runs, 1}, arcs_before{before.runs, 1};
    return compare_frames(one_segment(), match_points(now.clipped, before.clipped, viewport),
                          {now.clipped, now.alpha, now.truth, arcs},
                          {before.clipped, before.alpha, before.truth, arcs_before})
        .all;
}

TEST(Motion, NothingChangesWhereNothingMoves) {
    const MotionFigures figures = compare({}, {});
    EXPECT_EQ(figures.points, 100U);
    EXPECT_EQ(figures.stroke_points, 50U);
    EXPECT_EQ(figures.sparkle(), 0);
    EXPECT_EQ(figures.crawl(), 0);
}

TEST(Motion, AlphaThatShiftsByASampleSparklesThere) {
    EXPECT_DOUBLE_EQ(*compare({.alpha = alpha_step(51)}, {}).sparkle(), 0.01);
    EXPECT_DOUBLE_EQ(*compare({}, {.alpha = alpha_step(51)}).sparkle(), 0.01);
}

TEST(Motion, AlphaThatFollowsTheTruthDoesNotSparkle) {
    EXPECT_EQ(compare({.alpha = alpha_step(60), .truth = truth_step(60)}, {}).sparkle(), 0);
    // An error that stays does not sparkle.
    EXPECT_EQ(compare({.alpha = alpha_step(60)}, {.alpha = alpha_step(60)}).sparkle(), 0);
}

TEST(Motion, FlickerIsFound) {
    // Planted: every tenth sample goes out in one of the frames.
    Frame flickers;
    for (std::size_t j = 0; j < 50; j += 10) flickers.alpha[j] = 0;
    EXPECT_DOUBLE_EQ(*compare({}, flickers).sparkle(), 0.05);
}

TEST(Motion, ShiftedTextureCrawls) {
    const MotionFigures figures = compare({.runs = {stroke(0, 50, 0.7F)}}, {});
    EXPECT_EQ(figures.stroke_points, 50U);
    EXPECT_NEAR(*figures.crawl(), 0.7, 1e-5);
    EXPECT_EQ(figures.crawling_share(), 1);
}

TEST(Motion, CrawlCountsPointsOfStrokesInBothFrames) {
    const MotionFigures figures =
        compare({.runs = {stroke(0, 10), stroke(40, 100)}}, {.runs = {stroke(5, 45, 0.25F)}});
    EXPECT_EQ(figures.stroke_points, 10U); // 5 to 10 and 40 to 45
    EXPECT_DOUBLE_EQ(*figures.crawl(), 0.25);
    EXPECT_EQ(figures.crawling_share(), 0);
    EXPECT_FALSE(compare({.runs = {}}, {}).crawl().has_value());
}

TEST(Motion, PointsAreFoundAgainOnALineThatMoved) {
    const std::vector<Match> matches = match_points(line(100, 0.75F), line(100), viewport);
    ASSERT_EQ(matches.size(), 100U);
    for (const Match& match : matches) {
        EXPECT_NEAR(match.before, match.sample + 0.5, 1e-4);
    }
    EXPECT_TRUE(match_points(line(100, 1.25F), line(100), viewport).empty()) << "too fast";
}

TEST(Motion, PointsOutsideTheOtherFrameAreLeftOut) {
    // Only the second half of the segment was drawn: the same place on the screen, 100 pixels.
    ClippedLines half = line(50);
    half.clipped[0].p[0] = 0;
    half.clipped[0].t0 = 0.5F;
    const std::vector<Match> matches = match_points(line(100), half, viewport);
    ASSERT_EQ(matches.size(), 50U);
    EXPECT_EQ(matches.front().sample, 50U);
    EXPECT_NEAR(matches.front().before, 0.5, 1e-4);
}

TEST(Motion, EarlierFrameIsInterpolated) {
    // A ramp of truth, sampled differently in the two frames.
    Frame now, before{.clipped = line(101)};
    now.alpha.assign(100, 255);
    before.alpha.assign(101, 255);
    now.truth.resize(100);
    before.truth.resize(101);
    for (std::size_t j = 0; j < 100; ++j) now.truth[j] = (static_cast<float>(j) + 0.5F) / 100;
    for (std::size_t j = 0; j < 101; ++j) before.truth[j] = (static_cast<float>(j) + 0.5F) / 101;
    EXPECT_NEAR(*compare(now, before).sparkle(), 0, 1e-5);
}

TEST(Motion, ParametersAlongALineInPerspective) {
    ClippedSegment segment{};
    segment.p[3] = 1;
    segment.q[3] = 3;
    segment.t0 = 0.2F;
    segment.t1 = 0.7F;
    // Half of the way on the screen is a quarter of the way in space.
    EXPECT_NEAR(parameter_at(segment, 0.5), 0.325, 1e-7);
    EXPECT_NEAR(*share_at(segment, 0.325), 0.5, 1e-6);
    EXPECT_FALSE(share_at(segment, 0.71).has_value());
}

TEST(Motion, SpineTextureHasItsZeroInTheMiddleOfTheSegment) {
    std::vector<std::uint8_t> alpha = alpha_step(25);
    alpha[99] = 1;
    const auto runs = spine_runs(line(100), alpha, viewport);
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].start_arc, -100);
    EXPECT_EQ(runs[0].end_arc, -50);
    EXPECT_EQ(runs[1].start_sample, 99);
    EXPECT_EQ(runs[1].end_arc, 100);
}

TEST(Motion, BurstIsSlowWhereverTheEyeStands) {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    const LineSet lines = extract_lines(mesh);
    for (const double speed : {0.1, 10.0}) {
        const PathView view{"", 0.9, [speed](double t) {
                                View v;
                                v.eye = {speed * (t - 0.9), 0, 5};
                                v.target = v.eye - glm::vec3{0, 0, 5};
                                return v;
                            }};
        const Camera camera = make_camera(view.view(), viewport, lines.bounds);
        const ClippedLines clipped = clip_lines(lines, camera, 2);
        const std::vector<float> truth(clipped.offsets.back(), 1);
        const Burst burst = slow_burst(view, lines, viewport, 4, clipped, truth);
        EXPECT_EQ(burst.cameras.size(), 4U);
        // The model is flat, so all of its points move alike.
        EXPECT_NEAR(burst.typical_motion, 0.9, 0.02);
    }
}

} // namespace
} // namespace lineatlas::bench
