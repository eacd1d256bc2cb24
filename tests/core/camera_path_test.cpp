#include "lineatlas/camera_path.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

using Keys = std::vector<CameraPath::Key>;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

void expect_near(glm::vec3 a, glm::vec3 b) {
    EXPECT_LT(glm::distance(a, b), 1e-5F) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Turned, GoesCounterClockwiseSeenFromAbove) {
    // Around x = 1, z = 2: from in front of it to the right, behind it, to the left.
    const View view{.eye = {1, 3, 7}, .target = {1, 0, 4}, .near = 1, .far = 9};
    const Axis axis{.point = {1, -8, 2}};
    expect_near(turned(view, axis, 0).eye, view.eye);
    expect_near(turned(view, axis, 0.25).eye, {6, 3, 2});
    expect_near(turned(view, axis, 0.25).target, {3, 0, 2});
    expect_near(turned(view, axis, 0.5).eye, {1, 3, -3});
    expect_near(turned(view, axis, 0.75).eye, {-4, 3, 2});
    EXPECT_EQ(turned(view, axis, 0.5).near, 0);
    EXPECT_EQ(turned(view, axis, 0.5).far, 0);
    // The direction upwards turns, too.
    expect_near(turned({.up = {0, 1, 0}}, {.direction = {0, 0, 1}}, 0.25).up, {-1, 0, 0});
    EXPECT_THROW(turned(view, {.direction = {0, 2, 0}}, 0.25), UsageError);
    EXPECT_THROW(turned(view, {.direction = {0, not_a_number, 0}}, 0.25), UsageError);
}

TEST(Swept, BoundsTheCirclesOfAllPoints) {
    const Axis axis{.point = {10, 0, 0}};
    const std::vector<glm::vec3> points{{13, 1, 4}, {10, 1, 1}, {10, 6, 1}}; // 5, 1, 1 away
    const std::vector<glm::vec3> found = swept(points, axis);
    ASSERT_FALSE(found.empty());
    float widest = 0, low = 100, high = -100;
    for (const glm::vec3 p : found) {
        const float radius = glm::length(glm::vec2{p.x - 10, p.z});
        // Corners of a polygon about each circle, at the height of a point.
        EXPECT_TRUE(p.y == 1 || p.y == 6);
        EXPECT_GE(radius, p.y == 1 ? 5 : 1);
        EXPECT_LE(radius, p.y == 1 ? 5.03F : 1.01F);
        widest = std::max(widest, radius);
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    EXPECT_GT(widest, 5);
    EXPECT_EQ(low, 1);
    EXPECT_EQ(high, 6);
    EXPECT_TRUE(swept({}, axis).empty());
    EXPECT_THROW(swept(std::vector<glm::vec3>{{0, not_a_number, 0}, {1, 1, 1}}, axis), UsageError);
}

TEST(CameraPath, PassesItsKeysAndRestsBetweenThoseThatAreAlike) {
    const View first{.eye = {0, 0, 9}, .fov_y = 0.5F};
    const View second{.eye = {4, 0, 9}, .fov_y = 0.9F, .projection = Projection::orthographic};
    const CameraPath path{Keys{{0.5, first}, {4, second}, {6.5, second}}};
    EXPECT_EQ(path.first_frame(), 1);
    EXPECT_EQ(path.last_frame(), 6);
    EXPECT_EQ(path.view(0.5).eye, first.eye);
    EXPECT_EQ(path.view(-3).eye, first.eye);
    EXPECT_EQ(path.view(not_a_number).eye, first.eye);
    EXPECT_EQ(path.view(4).eye, second.eye);
    EXPECT_EQ(path.view(5).eye, second.eye);
    EXPECT_EQ(path.view(100).eye, second.eye);
    // The cubic starts with the slope of a straight way and ends with slope 0. In the middle it has
    // done 1/2 + 1/8 of the way.
    EXPECT_NEAR(path.view(2.25).eye.x, 4 * 0.625F, 1e-5F);
    EXPECT_NEAR(path.view(2.25).fov_y, 0.5F + 0.4F * 0.625F, 1e-5F);
    EXPECT_EQ(path.view(2.25).projection, Projection::perspective);
    EXPECT_EQ(path.view(4).projection, Projection::orthographic);
}

TEST(CameraPath, OfOneKeyStandsStill) {
    const CameraPath path{Keys{{3, View{.eye = {1, 2, 3}}}}};
    EXPECT_EQ(path.first_frame(), 3);
    EXPECT_EQ(path.last_frame(), 3);
    EXPECT_EQ(path.view(3).eye, glm::vec3(1, 2, 3));
}

TEST(CameraPath, RefusesKeysOutOfOrderOrRange) {
    for (const Keys& keys : {Keys{}, Keys{{1, {}}, {1, {}}}, Keys{{2, {}}, {1, {}}},
                             Keys{{1e7, {}}}, Keys{{not_a_number, {}}}})
        EXPECT_THROW(CameraPath{keys}, UsageError) << keys.size();
}

} // namespace
} // namespace lineatlas
