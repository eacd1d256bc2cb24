#include "core/screen_bounds.hpp"

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/camera.hpp"

namespace lineatlas {
namespace {

constexpr glm::ivec2 size{200, 100};

Camera camera_at(glm::vec3 eye, glm::vec3 target = {0, 0, 0}) {
    View view;
    view.eye = eye;
    view.target = target;
    view.fov_y = glm::radians(90.0F);
    view.near = 0.1F;
    view.far = 100;
    return make_camera(view, size, {});
}

TEST(ScreenBounds, AreWhatTheBoxCoversGrownToTiles) {
    // The front face spans 2 of the 4 units that the picture is high at a distance of 2: 50 texels.
    const Bounds box{{-1, -1, -1}, {1, 1, 1}};
    const glm::mat4 clip = camera_at({0, 0, 3}).clip_from_world();
    const TexelRectangle exact = screen_bounds(box, clip, size, 0, 1);
    EXPECT_NEAR(exact.low.x, 75, 1);
    EXPECT_NEAR(exact.low.y, 25, 1);
    EXPECT_NEAR(exact.high.x, 125, 1);
    EXPECT_NEAR(exact.high.y, 75, 1);
    const TexelRectangle tiles = screen_bounds(box, clip, size, 2, 16);
    EXPECT_EQ(tiles.low, glm::ivec2(64, 16));
    EXPECT_EQ(tiles.high, glm::ivec2(128, 80));
}

TEST(ScreenBounds, AreCutToThePicture) {
    const Bounds box{{-50, -1, -1}, {50, 1, 1}};
    const TexelRectangle covered =
        screen_bounds(box, camera_at({0, 0, 3}).clip_from_world(), size, 0, 16);
    EXPECT_EQ(covered.low.x, 0);
    EXPECT_EQ(covered.high.x, size.x);
    EXPECT_GT(covered.low.y, 0);
}

TEST(ScreenBounds, AreAllWhenTheEyeIsInsideAndNothingBesideThePicture) {
    const Bounds box{{-1, -1, -1}, {1, 1, 1}};
    const TexelRectangle inside =
        screen_bounds(box, camera_at({0, 0, 0.5F}).clip_from_world(), size, 0, 16);
    EXPECT_EQ(inside.size(), size);
    const glm::mat4 away = camera_at({0, 0, 3}, {20, 0, 0}).clip_from_world();
    const Bounds above{{5, 20, 0}, {6, 21, 1}};
    EXPECT_EQ(screen_bounds(above, away, size, 0, 16).size(), glm::ivec2(0, 0));
}

} // namespace
} // namespace lineatlas
