// intervals: pieces of lines that end between samples, where a wall begins.

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

using Intervals = std::vector<Interval>;

/// The kernel narrows an end down to a 64th of a sample, and gives the middle of that.
constexpr double of_sample = 1.0 / 64;

struct Scene {
    std::vector<HandLine> lines;
    std::vector<std::uint8_t> alpha{};
    std::vector<float> depth = std::vector<float>(64 * 64, 1.0F);
    std::vector<glm::vec3> vertices = std::vector<glm::vec3>(2);
    bool hidden_too = false;
    std::uint32_t capacity = 32; ///< intervals

    /// Adds a wall over all rows, from one column up to another, without the latter.
    void add_wall(int from, int to) {
        for (int y = 0; y < 64; ++y) {
            for (int x = from; x < to; ++x) depth[static_cast<std::size_t>(64 * y + x)] = 0.1F;
        }
    }
};

class IntervalsStage : public StageTest {
  protected:
    Intervals intervals(const Scene& scene) {
        HandFrame frame{device(), scene.lines};
        EXPECT_EQ(frame.samples(), scene.alpha.size());
        const auto vertices = put(scene.vertices);
        const auto alpha = put(scene.alpha);
        const auto depth = put(scene.depth);
        const auto table = put(std::vector<Interval>(32));
        const auto total = device().allocate(sizeof(std::uint32_t));
        stages().intervals({.table = frame.table(*vertices),
                            .atlas = {frame.clipped(), *alpha, 4096},
                            .viewport = glm::vec2{hand_size},
                            .depth = {*depth, hand_size, 1, 1e-4F},
                            .hidden_too = scene.hidden_too,
                            .into = {*table, scene.capacity, *total}});
        total_ = get<std::uint32_t>(*total, 1)[0];
        return get<Interval>(*table, total_ <= scene.capacity ? total_ : 0);
    }

    std::uint32_t total_ = 0;
};
INSTANTIATE_TEST_SUITE_P(OnDevice, IntervalsStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

/// 16 samples of two pixels from pixel 8 to 40. Samples in front of the walls are visible.
Scene level_scene(std::vector<std::pair<int, int>> walls, std::uint32_t tag = LA_KIND_CREASE) {
    Scene scene{.lines = {{{8, 20.5F, 0.25F, 1}, {40, 20.5F, 0.75F, 1}, 16, 0, 0, tag}}};
    for (const auto& [from, to] : walls) scene.add_wall(from, to);
    for (int j = 0; j < 16; ++j) {
        int hidden = 0; // hidden texels of the sample's two
        for (const auto& [from, to] : walls) {
            for (const int x : {8 + 2 * j, 9 + 2 * j}) hidden += x >= from && x < to ? 1 : 0;
        }
        scene.alpha.push_back(static_cast<std::uint8_t>(255 * (2 - hidden) / 2));
    }
    return scene;
}

std::uint32_t start_of(const Interval& interval) {
    return interval.flags >> LA_INTERVAL_START_SHIFT & LA_END_MASK;
}
std::uint32_t end_of(const Interval& interval) {
    return interval.flags >> LA_INTERVAL_END_SHIFT & LA_END_MASK;
}

TEST_P(IntervalsStage, EndsLieWhereTheWallBegins) {
    for (const int wall : {20, 21, 24, 27}) {
        SCOPED_TRACE(wall);
        Scene scene = level_scene({{wall, 64}});
        const Intervals visible = intervals(scene);
        ASSERT_EQ(visible.size(), 1U);
        const Interval& found = visible[0];
        const float end = static_cast<float>(wall);
        EXPECT_FLOAT_EQ(found.start[0], 8);
        EXPECT_NEAR(found.end[0], end, 2 * of_sample);
        EXPECT_FLOAT_EQ(found.end[1], 20.5F);
        EXPECT_NEAR(found.end_sample, (end - 8) / 2, of_sample);
        EXPECT_FLOAT_EQ(found.start_arc, -16);
        EXPECT_NEAR(found.end_arc, end - 24, 2 * of_sample);
        EXPECT_FLOAT_EQ(found.start_depth, 0.25F);
        EXPECT_NEAR(found.end_depth, 0.25F + (end - 8) / 64, of_sample / 16);
        EXPECT_NE(found.flags & LA_INTERVAL_VISIBLE, 0U);
        EXPECT_EQ(start_of(found), LA_END_PATH);
        EXPECT_EQ(end_of(found), LA_END_HIDDEN);
        EXPECT_EQ(found.segment, 0U);
        scene.hidden_too = true;
        const Intervals both = intervals(scene);
        ASSERT_EQ(both.size(), 2U);
        EXPECT_EQ(both[1].start_sample, both[0].end_sample) << "nothing between them";
        EXPECT_FLOAT_EQ(both[1].end[0], 40);
        EXPECT_EQ(both[1].flags & LA_INTERVAL_VISIBLE, 0U);
    }
}

TEST_P(IntervalsStage, AlphaIsTheMeanOfItsSamples) {
    Scene scene = level_scene({{24, 64}});
    scene.alpha = {255, 255, 255, 255, 153, 153, 255, 255, 51, 0, 0, 0, 0, 0, 0, 0};
    scene.hidden_too = true;
    const Intervals both = intervals(scene);
    ASSERT_EQ(both.size(), 2U);
    EXPECT_NEAR(both[0].alpha, 0.9, 1e-6);
    EXPECT_NEAR(both[1].alpha, 0.2 / 8, 1e-6);
}

TEST_P(IntervalsStage, GapsAndPiecesAreToldApart) {
    const Intervals visible = intervals(level_scene({{12, 16}, {30, 36}}));
    ASSERT_EQ(visible.size(), 3U);
    const double expected[][2] = {{8, 12}, {16, 30}, {36, 40}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(visible[i].start[0], expected[i][0], 2 * of_sample);
        EXPECT_NEAR(visible[i].end[0], expected[i][1], 2 * of_sample);
    }
}

TEST_P(IntervalsStage, HalfOfItsBoxIsEnoughAndAQuarterOfASilhouettes) {
    for (const auto& [alpha, tag, count] : {std::tuple{127, LA_KIND_CREASE, 0U},
                                            {128, LA_KIND_CREASE, 1U},
                                            {63, LA_KIND_SILHOUETTE, 0U},
                                            {64, LA_KIND_SILHOUETTE, 1U}}) {
        Scene scene = level_scene({}, tag);
        scene.alpha.assign(16, static_cast<std::uint8_t>(alpha));
        EXPECT_EQ(intervals(scene).size(), count) << alpha;
    }
    // So a silhouette ends farther behind a wall: where 3 of 9 probes see it, from 2/9 of a pixel
    // on, and not 5.
    EXPECT_NEAR(intervals(level_scene({{24, 64}}, LA_KIND_SILHOUETTE))[0].end[0], 24 + 2.0 / 9,
                2 * of_sample);
}

TEST_P(IntervalsStage, PlacesInTheModelAreThoseThatAreSeen) {
    // Seen in perspective from w = 1 to w = 3, and cut to a part of its segment.
    Scene scene = level_scene({{24, 64}});
    scene.lines[0].p.w = 1;
    scene.lines[0].q.w = 3;
    scene.lines[0].t0 = 0.25F;
    scene.lines[0].t1 = 0.75F;
    scene.lines[0].vertex_q = 1;
    scene.vertices = {{0, 10, -4}, {8, 10, 4}};
    const Intervals visible = intervals(scene);
    ASSERT_EQ(visible.size(), 1U);
    // Half way on the screen is f of the way in space with 3 f = 1 - f.
    const double t = 0.25 + 0.5 * 0.25;
    EXPECT_TRUE(equal<float>({visible[0].start_world, visible[0].start_world + 3}, {2, 10, -2}));
    EXPECT_NEAR(visible[0].end_world[0], 8 * t, 0.02);
    EXPECT_NEAR(visible[0].end_world[1], 10, 1e-5);
    EXPECT_NEAR(visible[0].end_world[2], -4 + 8 * t, 0.02);
    EXPECT_EQ(start_of(visible[0]), LA_END_CLIPPED);
}

/// Two segments of a path that meet at pixel 24.
Scene path_scene(int wall, std::vector<std::uint8_t> alpha) {
    Scene scene{.lines = {{{8, 20.5F, 0.5F, 1}, {24, 20.5F, 0.5F, 1}, 4, 0, 1},
                          {{24, 20.5F, 0.5F, 1}, {40, 20.5F, 0.5F, 1}, 4, 1, 0}},
                .alpha = std::move(alpha)};
    scene.add_wall(wall, 64);
    return scene;
}

TEST_P(IntervalsStage, AtAJointVisibilityMayChangeOnEitherSide) {
    const std::vector<std::uint8_t> alpha{255, 255, 255, 255, 0, 0, 0, 0};
    // Samples have four pixels. The wall begins half a sample before the vertex, so the second
    // segment is hidden from its start.
    Scene scene = path_scene(23, alpha);
    const Intervals before = intervals(scene);
    ASSERT_EQ(before.size(), 2U);
    EXPECT_NEAR(before[0].end[0], 23, 4 * of_sample);
    EXPECT_EQ(before[1].segment, 1U);
    EXPECT_EQ(before[1].start_sample, 0);
    EXPECT_EQ(before[1].end_sample, 0) << "of no length";
    // The wall begins half a sample after the vertex.
    const Intervals after = intervals(path_scene(25, alpha));
    ASSERT_EQ(after.size(), 2U);
    EXPECT_FLOAT_EQ(after[0].end[0], 24);
    EXPECT_NEAR(after[1].end[0], 25, 4 * of_sample);
    EXPECT_EQ(start_of(after[1]), LA_END_JOIN);
    EXPECT_EQ(end_of(after[1]), LA_END_HIDDEN);
}

TEST_P(IntervalsStage, SegmentsThatWereDroppedAreHiddenWhole) {
    Scene scene = level_scene({{24, 64}});
    scene.lines.push_back({{8, 30.5F, 0.5F, 1}, {24, 30.5F, 0.5F, 1}, 0});
    EXPECT_EQ(intervals(scene).size(), 1U);
    scene.hidden_too = true;
    const Intervals all = intervals(scene);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[2].segment, 1U);
    EXPECT_EQ(all[2].alpha, 0);
    EXPECT_FLOAT_EQ(all[2].start[0], 8);
    EXPECT_FLOAT_EQ(all[2].end[0], 24);
}

TEST_P(IntervalsStage, TablesThatAreTooSmallAreReported) {
    Scene scene = level_scene({{12, 16}, {30, 36}});
    scene.capacity = 2;
    EXPECT_TRUE(intervals(scene).empty());
    EXPECT_EQ(total_, 3U);
}

} // namespace
} // namespace lineatlas::test
