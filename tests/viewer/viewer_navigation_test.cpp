// The camera in a person's hand, without any window.

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/scenes.hpp"
#include "viewer/navigation.hpp"

namespace lineatlas::test {
namespace {

using viewer::Navigation;

constexpr glm::dvec2 size{800, 600};
constexpr double pixel = 0.01; // a hundredth, because the view's numbers are floats

Navigation at(glm::vec3 eye, glm::vec3 target = {0, 0, 0}) {
    Navigation navigation;
    navigation.set_view({.eye = eye, .target = target});
    return navigation;
}

glm::dvec2 seen(const Navigation& navigation, glm::dvec3 point) {
    const std::optional<glm::dvec2> place = viewer::seen_at(navigation.view(), point, size);
    EXPECT_TRUE(place.has_value());
    return place.value_or(glm::dvec2{std::numeric_limits<double>::quiet_NaN()});
}

void expect_near(glm::dvec2 a, glm::dvec2 b, double tolerance = pixel) {
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << ", " << a.y << " and " << b.x << ", " << b.y;
}

TEST(Navigation, ARayGoesThroughWhatIsSeenThere) {
    const Navigation navigation = at({3, 2, 5});
    for (const glm::dvec3 point : {glm::dvec3{0.4, -0.3, 0.2}, glm::dvec3{-1, 1, 1}}) {
        const Ray ray = viewer::ray_at(navigation.view(), seen(navigation, point), size);
        EXPECT_LT(glm::length(glm::cross(point - ray.origin, ray.direction)), 1e-5);
    }
}

TEST(Navigation, SeesWhatTheCameraSees) {
    const Navigation navigation = at({3, 2, 5});
    const glm::vec4 point{0.4F, -0.3F, 0.2F, 1};
    const Camera camera =
        make_camera(navigation.view(), size, {.min = glm::vec3{-1}, .max = glm::vec3{1}});
    const glm::vec4 clip = camera.clip_from_world() * point;
    const glm::dvec2 ndc{clip.x / clip.w, clip.y / clip.w};
    expect_near(seen(navigation, glm::vec3{point}),
                {0.5 * size.x * (1 + ndc.x), 0.5 * size.y * (1 - ndc.y)});
}

TEST(Navigation, GoesAwayThroughNearWalls) {
    Navigation navigation = at({0.5, 0, 5}, {0.5, 0, 0});
    const glm::dvec3 wall{0.5003, 0.0001, 4.999}; // just before the eye
    const glm::dvec2 before = seen(navigation, wall);
    double gone = 0;
    for (int click = 0; click < 8; ++click) {
        const glm::dvec3 eye = navigation.view().eye;
        navigation.dolly(wall, 1 / 0.88);
        const double step = glm::distance(eye, glm::dvec3{navigation.view().eye});
        EXPECT_GT(step, gone) << "faster and faster";
        gone = step;
        if (click == 0) expect_near(seen(navigation, wall), before, 0.1);
    }
    EXPECT_GT(navigation.view().eye.z, 10) << "8 clicks take the eye to three times the distance";
    const glm::dvec3 eye = navigation.view().eye;
    navigation.dolly(eye - glm::dvec3{0, 0, 0.01}, 0.88);
    EXPECT_LT(glm::distance(eye, glm::dvec3{navigation.view().eye}), 0.01) << "nearer as before";
}

TEST(Navigation, OrbitLeavesThePivotWhereItIsSeen) {
    Navigation navigation = at({3, 2, 5});
    const glm::dvec3 pivot{0.7, 0.4, -0.2};
    const glm::dvec2 before = seen(navigation, pivot);
    const double distance = glm::distance(glm::dvec3{navigation.view().eye}, pivot);
    for (int i = 0; i < 50; ++i) {
        navigation.orbit(pivot, {0.13, i % 2 == 0 ? 0.05 : -0.03});
        expect_near(seen(navigation, pivot), before);
    }
    EXPECT_NEAR(glm::distance(glm::dvec3{navigation.view().eye}, pivot), distance, 1e-4);
    EXPECT_EQ(navigation.view().up, (glm::vec3{0, 1, 0})) << "the view has rolled";
}

TEST(Navigation, AFullTurnComesBack) {
    Navigation navigation = at({3, 2, 5});
    for (int i = 0; i < 36; ++i) navigation.orbit({0, 0, 0}, {glm::radians(10.0), 0});
    EXPECT_LT(glm::distance(navigation.view().eye, glm::vec3{3, 2, 5}), 1e-4F);
}

TEST(Navigation, OrbitEndsAtTheVertical) {
    for (const double way : {-9.0, 9.0}) {
        Navigation navigation = at({3, 2, 5});
        navigation.orbit({0, 0, 0}, {0, way});
        const View& view = navigation.view();
        EXPECT_NO_THROW(make_camera(view, size, {.min = glm::vec3{-1}, .max = glm::vec3{1}}));
        const glm::vec3 ahead = glm::normalize(view.target - view.eye);
        EXPECT_GT(std::abs(ahead.y), 0.9999F);
        EXPECT_EQ(ahead.y > 0, way > 0);
    }
}

TEST(Navigation, LookTurnsAboutTheEye) {
    Navigation navigation = at({3, 2, 5});
    navigation.look({0.3, 0.1});
    EXPECT_LT(glm::distance(navigation.view().eye, glm::vec3{3, 2, 5}), 1e-6F);
    EXPECT_GT(glm::length(navigation.view().target), 0.5F);
}

TEST(Navigation, PanKeepsThePointUnderTheMouse) {
    Navigation navigation = at({3, 2, 5});
    const glm::dvec3 held{0.7, 0.4, -0.2};
    const glm::dvec2 from = seen(navigation, held), to = from + glm::dvec2{120, -75};
    navigation.pan(held, from, to, size);
    expect_near(seen(navigation, held), to);
}

TEST(Navigation, DollyGoesToThePointUnderTheMouse) {
    Navigation navigation = at({3, 2, 5});
    const glm::dvec3 to{0.7, 0.4, -0.2};
    const glm::dvec2 before = seen(navigation, to);
    const double distance = glm::distance(glm::dvec3{navigation.view().eye}, to);
    navigation.dolly(to, 0.25);
    expect_near(seen(navigation, to), before);
    EXPECT_NEAR(glm::distance(glm::dvec3{navigation.view().eye}, to), 0.25 * distance, 1e-5);
}

TEST(Navigation, FliesAheadRightAndUp) {
    Navigation navigation = at({0, 0, 5});
    navigation.fly({1, 2, 3});
    EXPECT_LT(glm::distance(navigation.view().eye, glm::vec3{1, 2, 2}), 1e-6F);
    EXPECT_LT(glm::distance(navigation.view().target, glm::vec3{1, 2, -3}), 1e-6F);
}

TEST(Navigation, GlidesWithoutRollingAndArrivesExactly) {
    Navigation navigation = at({3, 2, 5});
    const View goal{.eye = {-4, 3, -2}, .target = {0.5F, 0, 0}};
    navigation.glide_to(goal);
    EXPECT_EQ(navigation.goal().eye, goal.eye);
    const float shortest =
        std::min(glm::length(glm::vec3{3, 2, 5}), glm::distance(goal.eye, goal.target));
    int steps = 0;
    for (; navigation.gliding() && steps < 1000; ++steps) {
        navigation.advance(0.01);
        const View& view = navigation.view();
        EXPECT_GT(glm::distance(view.eye, view.target), 0.999F * shortest) << "through the model";
        EXPECT_EQ(view.up, goal.up);
    }
    EXPECT_GT(steps, 10);
    EXPECT_EQ(navigation.view().eye, goal.eye);
    EXPECT_EQ(navigation.view().target, goal.target);
}

TEST(Navigation, HoweverFarOneTurnsTheWheelThereIsAWayBack) {
    for (const double factor : {0.88, 1 / 0.88}) {
        Navigation navigation = at({3, 2, 5});
        for (int i = 0; i < 2000; ++i) navigation.dolly({0.5, 0.25, 0}, factor);
        navigation.orbit({0.5, 0.25, 0}, {0.1, 0.1});
        navigation.fly({1, 1, 1});
        const View there = navigation.view();
        const auto distance = [](const View& view) { return glm::distance(view.eye, view.target); };
        EXPECT_GT(distance(there), 0);
        EXPECT_TRUE(std::isfinite(distance(there)));
        for (int i = 0; i < 100; ++i) navigation.dolly({0.5, 0.25, 0}, 1 / factor);
        EXPECT_GT(std::abs(std::log(distance(navigation.view()) / distance(there))), 10);
    }
}

TEST(Navigation, StandardViewsLookAlongTheAxesOfTheModel) {
    using viewer::StandardView;
    const glm::vec3 y{0, 1, 0}, z{0, 0, 1};
    const auto expect = [](StandardView view, glm::vec3 up, glm::vec3 direction) {
        EXPECT_GT(glm::dot(viewer::direction_to(view, up), direction), 0.99999F);
    };
    expect(StandardView::front, y, {0, 0, 1});
    expect(StandardView::right, y, {1, 0, 0});
    expect(StandardView::top, y, {0, 1, 0});
    expect(StandardView::front, z, {0, -1, 0});
    expect(StandardView::right, z, {1, 0, 0});
    expect(StandardView::bottom, z, {0, 0, -1});
    for (const glm::vec3 up : {y, z, glm::vec3{1, 0, 0}}) {
        for (int i = 0; i <= static_cast<int>(StandardView::corner); ++i) {
            const glm::vec3 direction = viewer::direction_to(static_cast<StandardView>(i), up);
            EXPECT_NEAR(glm::length(direction), 1, 1e-6F);
            EXPECT_GT(glm::length(glm::cross(direction, up)), 1e-4F);
        }
    }
}

TEST(Navigation, AFittedViewHoldsTheModelFromEverySide) {
    const LineSet lines = extract_lines(make_scene("house").mesh);
    for (int i = 0; i <= static_cast<int>(viewer::StandardView::corner); ++i) {
        const glm::vec3 side =
            viewer::direction_to(static_cast<viewer::StandardView>(i), {0, 1, 0});
        const View view = frame_points_from({side, {0, 1, 0}}, lines.vertices, size);
        glm::dvec2 low{1e9}, high{-1e9};
        for (const glm::vec3 point : lines.vertices) {
            const auto place = viewer::seen_at(view, point, size);
            ASSERT_TRUE(place.has_value());
            low = glm::min(low, *place);
            high = glm::max(high, *place);
        }
        EXPECT_GT(std::min(low.x, low.y), 0);
        EXPECT_LT(high.x, size.x);
        EXPECT_LT(high.y, size.y);
        EXPECT_GT(std::max((high - low).x / size.x, (high - low).y / size.y), 0.85);
    }
}

TEST(Navigation, PicksTheNearestTriangle) {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const LineSet lines = extract_lines(mesh);
    const auto hit = viewer::pick(lines, {{0.1, 0, 5}, {0, 0, -1}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(glm::distance(*hit, glm::dvec3{0.1, 0, 1}), 1e-12);
    EXPECT_FALSE(viewer::pick(lines, {{5, 0, 5}, {0, 0, -1}}).has_value());
    EXPECT_FALSE(viewer::pick(lines, {{0, 0, 5}, {0, 0, 1}}).has_value()) << "behind the eye";
}

} // namespace
} // namespace lineatlas::test
