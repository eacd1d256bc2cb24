// transform, transform_bounds and transform_forget: objects moved by matrices with known effects.

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

LINEATLAS_STAGE_TEST(TransformStage);

/// Three rows of four: a quarter turn about z with a shift, and a stretch of each axis.
const std::vector<float> matrices{0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30,
                                  2, 0,  0, 1,  0, 3, 0, 2,  0, 0, 4, 3};

TEST_P(TransformStage, VerticesMoveByTheMatrixOfTheirObject) {
    const auto rest = put(std::vector<glm::vec3>{{1, 2, 3}, {1, 2, 3}, {-4, 5, 0.5F}});
    const auto objects = put(std::vector<std::uint32_t>{1, 0, 0});
    const auto rows = put(matrices);
    const auto vertices = device().allocate(3 * sizeof(glm::vec3));
    const auto drawn = device().allocate(3 * sizeof(glm::vec3));
    stages().launch_each<compute::kernels::transform>(3, {.rest = *rest,
                                                          .objects = *objects,
                                                          .matrices = *rows,
                                                          .vertices = *vertices,
                                                          .drawn = *drawn});
    const std::vector<float> expected{3, 8, 15, 8, 21, 33, 5, 16, 30.5F};
    EXPECT_TRUE(equal(get<float>(*vertices, 9), expected));
    EXPECT_TRUE(equal(get<float>(*drawn, 9), expected));
}

TEST_P(TransformStage, BoxesGrowAroundWhatMoved) {
    const auto rows =
        put(std::vector<float>{-0.6F, -0.8F, 0, 10, -0.8F, 0.6F, 0, 20, 0, 0, -2, 30});
    const auto objects = put(std::vector<std::uint32_t>{0, 0});
    const auto rest_boxes =
        put(std::vector<Cluster>{{{-1, 0, 1}, {1, 2, 3}, 7, 5}, {{4, 4, 4}, {4, 4, 4}, 12, 1}});
    const auto boxes = device().allocate(2 * sizeof(Cluster));
    stages().launch_each<compute::kernels::transform_boxes>(
        2, {.rest = *rest_boxes, .objects = *objects, .matrices = *rows, .clusters = *boxes});
    const auto seen = get<Cluster>(*boxes, 2);
    // The corners, turned: x is 10 - 0.6 x - 0.8 y, y is 20 - 0.8 x + 0.6 y, z is 30 - 2 z.
    const Cluster expected[] = {{{7.8F, 19.2F, 24}, {10.6F, 22, 28}, 7, 5},
                                {{4.4F, 19.2F, 22}, {4.4F, 19.2F, 22}, 12, 1}};
    for (std::size_t i = 0; i < 2; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(seen[i].low[axis], expected[i].low[axis]);
            EXPECT_GE(seen[i].high[axis], expected[i].high[axis]);
            EXPECT_NEAR(seen[i].low[axis], expected[i].low[axis], 2e-4);
            EXPECT_NEAR(seen[i].high[axis], expected[i].high[axis], 2e-4);
        }
        EXPECT_EQ(seen[i].first, expected[i].first);
        EXPECT_EQ(seen[i].count, expected[i].count);
    }
}

TEST_P(TransformStage, BoundsAreThoseOfAClustersOwnTriangles) {
    const auto vertices = put(std::vector<glm::vec3>{
        {1, 5, -3}, {2, -4, 7}, {0, 6, 1}, {-9, -9, -9}, {8, 8, 8}, {3, 0, 9}});
    const auto triangles = put(std::vector<glm::uvec3>{{3, 3, 4}, {0, 1, 2}, {2, 1, 5}, {4, 4, 4}});
    const auto boxes = put(std::vector<Cluster>{{{}, {}, 1, 2}, {{}, {}, 3, 1}});
    stages().launch_each<compute::kernels::transform_bounds>(
        2, {.vertices = *vertices, .triangles = *triangles, .clusters = *boxes});
    const auto seen = get<Cluster>(*boxes, 2);
    EXPECT_TRUE(equal<float>({seen[0].low, seen[0].low + 3}, {0, -4, -3}));
    EXPECT_TRUE(equal<float>({seen[0].high, seen[0].high + 3}, {3, 6, 9}));
    EXPECT_TRUE(equal<float>({seen[1].low, seen[1].low + 3}, {8, 8, 8}));
    EXPECT_TRUE(equal<float>({seen[1].high, seen[1].high + 3}, {8, 8, 8}));
    EXPECT_EQ(seen[0].first, 1U);
    EXPECT_EQ(seen[0].count, 2U);
}

TEST_P(TransformStage, SegmentsOfObjectsThatJumpedAreForgotten) {
    std::vector<Segment> lines(4);
    for (std::uint32_t i = 0; i < 4; ++i) lines[i].p = 3 - i;
    const auto segments = put(lines);
    const auto objects = put(std::vector<std::uint32_t>{2, 1, 0, 1});
    const auto jumped = put(std::vector<std::uint8_t>{0, 1, 0});
    const auto ranges = put(std::vector<std::uint32_t>{11, 12, 13, 14});
    stages().launch_each<compute::kernels::transform_forget>(
        4, {.segments = *segments, .objects = *objects, .jumped = *jumped, .ranges = *ranges});
    EXPECT_TRUE(equal(get<std::uint32_t>(*ranges, 4), {0, 12, 0, 14}));
}

} // namespace
} // namespace lineatlas::test
