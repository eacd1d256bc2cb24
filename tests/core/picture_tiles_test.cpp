#include <array>

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include "core/tiles.hpp"

namespace lineatlas::test {
namespace {

TEST(PictureTiles, CoverEveryPixelOnceFromTheTopLeft) {
    for (const int tile_size : {1, 3, 5, 7, 20}) {
        const std::vector<PictureTile> tiles = make_tiles({7, 5}, tile_size);
        std::array<int, 35> covered{};
        for (const PictureTile& tile : tiles) {
            EXPECT_LE(tile.size.x, tile_size);
            EXPECT_LE(tile.size.y, tile_size);
            for (int y = tile.low.y; y < tile.low.y + tile.size.y; ++y) {
                for (int x = tile.low.x; x < tile.low.x + tile.size.x; ++x) {
                    ++covered.at(static_cast<std::size_t>(y * 7 + x));
                }
            }
        }
        for (const int times : covered) EXPECT_EQ(times, 1) << tile_size;
        EXPECT_EQ(tiles.front().low.x, 0);
        EXPECT_EQ(tiles.front().low.y + tiles.front().size.y, 5);
    }
}

TEST(PictureTiles, ATransformTakesTheTilesCornersToThoseOfItsClipSpace) {
    const glm::ivec2 size{400, 300};
    EXPECT_EQ(tile_transform({{0, 0}, size}, size), whole_picture);
    const PictureTile tile{{100, 30}, {50, 60}};
    const glm::vec4 transform = tile_transform(tile, size);
    for (const int corner : {0, 1}) {
        const glm::vec2 window = glm::vec2{tile.low + corner * tile.size};
        const glm::vec2 clip = window / glm::vec2{size} * 2.0F - 1.0F;
        constexpr float w = 3;
        const glm::vec4 point{clip * w, 0.5F, w};
        const glm::vec4 in_tile = tile_projection(glm::mat4{1}, tile, size) * point;
        const float expected = corner == 0 ? -w : w;
        EXPECT_NEAR(in_tile.x, expected, 1e-5F);
        EXPECT_NEAR(in_tile.y, expected, 1e-5F);
        EXPECT_EQ(in_tile.z, point.z);
        EXPECT_EQ(in_tile.w, w);
        EXPECT_NEAR(point.x * transform.x + w * transform.z, expected, 1e-5F);
        EXPECT_NEAR(point.y * transform.y + w * transform.w, expected, 1e-5F);
    }
}

} // namespace
} // namespace lineatlas::test
