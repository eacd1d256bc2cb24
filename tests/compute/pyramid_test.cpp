// pyramid: one texel in each tile is farther than all others. Wrong borders of tiles would miss
// these texels.

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

LINEATLAS_STAGE_TEST(PyramidStage);

struct Texel {
    int x, y;
    float depth;
};

/// A buffer that is 0.25 everywhere else.
std::vector<float> depth_with(glm::ivec2 size, const std::vector<Texel>& texels) {
    std::vector<float> depth(static_cast<std::size_t>(size.x * size.y), 0.25F);
    for (const Texel& texel : texels) {
        depth[static_cast<std::size_t>(texel.y * size.x + texel.x)] = texel.depth;
    }
    return depth;
}

TEST_P(PyramidStage, IsTheFarthestDepthOfEveryTile) {
    // Three by three tiles of 16 texels; the last of each row is 5 wide, of each column 3 high.
    const glm::ivec2 size{37, 35};
    ASSERT_EQ(compute::tiles_for(size), glm::ivec2(3, 3));
    const auto depth = put(depth_with(size, {{0, 0, 0.31F},
                                             {31, 0, 0.32F},
                                             {36, 15, 0.33F},
                                             {15, 31, 0.34F},
                                             {16, 16, 0.35F},
                                             {32, 16, 0.36F},
                                             {7, 34, 0.37F},
                                             {31, 34, 0.38F},
                                             {36, 34, 0.39F}}));
    const auto tiles = device().allocate(9 * sizeof(float));
    stages().pyramid(*depth, size, *tiles);
    EXPECT_TRUE(equal(get<float>(*tiles, 9),
                      {0.31F, 0.32F, 0.33F, 0.34F, 0.35F, 0.36F, 0.37F, 0.38F, 0.39F}));
}

TEST_P(PyramidStage, EveryTexelCounts) {
    const glm::ivec2 size{32, 16};
    const auto tiles = device().allocate(2 * sizeof(float));
    for (int x = 0; x < 32; ++x) {
        const int y = x * 7 % 16;
        const auto depth = put(depth_with(size, {{x, y, 1}}));
        stages().pyramid(*depth, size, *tiles);
        const std::vector<float> expected =
            x < 16 ? std::vector{1.0F, 0.25F} : std::vector{0.25F, 1.0F};
        EXPECT_TRUE(equal(get<float>(*tiles, 2), expected)) << x << ", " << y;
    }
}

} // namespace
} // namespace lineatlas::test
