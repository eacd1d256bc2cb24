// cull: boxes in and out of the frustum, and before and behind a given depth pyramid.

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

/// 64 by 48 texels: four by three tiles.
class CullStage : public StageTest {
  protected:
    std::vector<std::uint32_t> visible(const std::vector<Cluster>& clusters,
                                       const glm::mat4& clip_from_world = glm::mat4{1}) {
        const auto boxes = put(clusters);
        const auto tiles = put(tiles_);
        const auto result = device().allocate(clusters.size() * sizeof(la_uint));
        const auto count = static_cast<std::uint32_t>(clusters.size());
        stages().launch<compute::kernels::cull>(
            count,
            {.count = count,
             .clip_from_world = clip_from_world,
             .depth_size = {64, 48},
             .tile_count = {4, 3}},
            {.clusters = *boxes, .tiles = *tiles, .visible = *result});
        return get<std::uint32_t>(*result, clusters.size());
    }

    static Cluster box(glm::vec3 low, glm::vec3 high) {
        return {{low.x, low.y, low.z}, {high.x, high.y, high.z}, 0, 1};
    }

    std::vector<float> tiles_ = std::vector<float>(12, 1.0F);
};
INSTANTIATE_TEST_SUITE_P(OnDevice, CullStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST_P(CullStage, WhatLiesOutsideOneOfSixPlanesIsNotSeen) {
    EXPECT_TRUE(
        equal(visible({box({-0.1F, -0.1F, -0.1F}, {0.1F, 0.1F, 0.1F}),
                       box({-3, -0.1F, -0.1F}, {-1.01F, 0.1F, 0.1F}),
                       box({1.01F, -0.1F, -0.1F}, {3, 0.1F, 0.1F}),
                       box({-0.1F, -3, -0.1F}, {0.1F, -1.01F, 0.1F}),
                       box({-0.1F, 1.01F, -0.1F}, {0.1F, 3, 0.1F}),
                       box({-0.1F, -0.1F, -3}, {0.1F, 0.1F, -1.01F}),
                       box({-0.1F, -0.1F, 1.01F}, {0.1F, 0.1F, 3}),
                       box({-3, -3, 0}, {3, 3, 0.1F}), // corners outside, around the frustum
                       box({0.99F, 0.99F, 0}, {3, 3, 0.1F})}),
              {1, 0, 0, 0, 0, 0, 0, 1, 1}));
}

TEST_P(CullStage, WhatLiesBehindAllTilesItTouchesIsNotSeen) {
    // Tile (1, 1) is filled at 0.3: texels 16 to 32 across and up, one less with the margin.
    tiles_[5] = 0.3F;
    const auto at = [](float texel, float size) { return texel / size * 2 - 1; };
    const auto in_tile = [&](float low, float high, float depth) {
        const float z = depth * 2 - 1;
        return box({at(low, 64), at(low, 48), z}, {at(high, 64), at(high, 48), 0.9F});
    };
    EXPECT_TRUE(
        equal(visible({in_tile(18, 30, 0.31F), in_tile(18, 30, 0.29F), in_tile(17.1F, 30.9F, 0.31F),
                       in_tile(16.9F, 30, 0.31F), in_tile(18, 31.1F, 0.31F)}),
              {0, 1, 0, 1, 1}));
}

TEST_P(CullStage, PerspectiveIsDividedOut) {
    // Looks along -z with planes at 1 and 3 and 90 degrees. The window has x and y divided by -z,
    // and depth 1.5 + 1.5 / z.
    const glm::mat4 clip_from_world{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -2, -1}, {0, 0, -3, 0}};
    // x 0.5 / 2.5 to 0.75 / 2: texels 38.4 to 44; y the same: 28.8 to 33, which touches two rows of
    // tiles. Its nearest depth is 0.75.
    const Cluster far_box = box({0.5F, 0.5F, -2.5F}, {0.75F, 0.75F, -2});
    const auto seen_behind = [&](float lower, float upper) {
        tiles_[6] = lower;
        tiles_[10] = upper;
        return visible({far_box}, clip_from_world)[0] == 1;
    };
    EXPECT_FALSE(seen_behind(0.74F, 0.74F));
    EXPECT_TRUE(seen_behind(0.76F, 0.74F));
    EXPECT_TRUE(seen_behind(0.74F, 0.76F));
    // A box that reaches behind the eye may be visible, because it has no place on the screen
    // there.
    tiles_.assign(12, 0.0F);
    EXPECT_TRUE(
        equal(visible({box({0.5F, 0.5F, -2}, {0.6F, 0.6F, 1}), far_box}, clip_from_world), {1, 0}));
}

} // namespace
} // namespace lineatlas::test
