// Circles and ellipses in which planes cut surfaces, held against the surfaces' own distances.
#include "surface/plane_section.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "surface/round_surface.hpp"
#include "surface/surface_point.hpp"

namespace lineatlas {
namespace {

constexpr glm::dvec3 axis{0, 0, 1};

SurfaceShape turned_line(glm::dvec3 from, glm::dvec3 way) {
    return {.axis = axis, .curve = {.point = from, .u = way}};
}

SurfaceShape turned_circle(glm::dvec3 center, double radius) {
    return {.axis = axis,
            .curve = {.kind = SurfaceCurve::Kind::ellipse,
                      .point = center,
                      .u = {radius, 0, 0},
                      .v = {0, 0, radius}}};
}

const SurfaceShape cylinder = turned_line({5, 0, 0}, {0, 0, 1});
const SurfaceShape cone = turned_line({5, 0, 0}, {-0.5, 0, 1}); // its tip at a height of 10
const SurfaceShape ball = turned_circle({0, 0, 2}, 5);
const SurfaceShape torus = turned_circle({20, 0, 0}, 5);

/// A place for shapes, turned, twice as large, and off the origin.
PlacedSurface placed() {
    const glm::dmat4 turned = glm::rotate(glm::dmat4{1}, 0.7, glm::dvec3{1, 2, -1});
    const glm::dmat4 grown = glm::scale(turned, glm::dvec3{2});
    return {.model_from_shape = glm::dmat4x3{glm::translate(grown, glm::dvec3{3, -4, 9})}};
}

/// The curve in a plane of the shape's own coordinates, near a place of the surface.
std::optional<SurfaceCurve> cut(const SurfaceShape& shape, glm::dvec3 point, glm::dvec3 normal,
                                glm::dvec2 at) {
    const PlacedSurface place = placed();
    const glm::dmat3 axes{place.model_from_shape};
    const glm::dvec3 through = place.model_from_shape * glm::dvec4{point, 1},
                     across = axes * normal;
    const std::optional<SurfaceCurve> curve =
        plane_section(shape, shape, place, through, across, at);
    if (!curve) return curve;
    EXPECT_EQ(curve->kind, SurfaceCurve::Kind::ellipse);
    EXPECT_NEAR(glm::dot(curve->u, curve->v), 0, 1e-9);
    for (int i = 0; i < 16; ++i) {
        const double angle = i * std::numbers::pi / 8;
        const glm::dvec3 on =
            curve->point + std::cos(angle) * curve->u + std::sin(angle) * curve->v;
        EXPECT_NEAR(glm::dot(on - through, glm::normalize(across)), 0, 1e-9);
        EXPECT_TRUE(holds_place(shape, place, on, 1e-9)) << angle;
    }
    return curve;
}

TEST(PlaneSection, CylindersAreCutInEllipses) {
    const auto across = cut(cylinder, {0, 0, 3}, {0, 0, 1}, {0.3, 2});
    ASSERT_TRUE(across);
    EXPECT_NEAR(glm::length(across->u), 10, 1e-9);
    EXPECT_NEAR(glm::length(across->v), 10, 1e-9);
    const auto aslant = cut(cylinder, {0, 0, 3}, {0, 1, 1}, {0.3, 2});
    ASSERT_TRUE(aslant);
    EXPECT_NEAR(glm::length(aslant->u), 10 * std::numbers::sqrt2, 1e-9);
    EXPECT_NEAR(glm::length(aslant->v), 10, 1e-9);
    EXPECT_FALSE(cut(cylinder, {1, 0, 0}, {1, 0, 0}, {0.3, 2})); // two lines
}

TEST(PlaneSection, ConesAreCutInEllipsesByPlanesFlatterThanTheyAre) {
    EXPECT_TRUE(cut(cone, {0, 0, 3}, {0, 0, 1}, {0.3, 2}));
    EXPECT_TRUE(cut(cone, {0, 0, 3}, {0.4, 0.2, 1}, {0.3, 2}));
    EXPECT_FALSE(cut(cone, {0, 0, 3}, {2, 0, 1}, {0.3, 2})); // a parabola
    EXPECT_FALSE(cut(cone, {1, 0, 3}, {1, 0, 0}, {0.3, 2})); // a hyperbola
}

TEST(PlaneSection, SpheresAreCutInCircles) {
    const std::array<glm::dvec3, 3> normals{{{0, 0, 1}, {1, 0, 0}, {0.3, 0.2, 1}}};
    for (const glm::dvec3& normal : normals) {
        const auto circle = cut(ball, {0.5, 0.25, 3}, normal, {0.3, 0.5});
        ASSERT_TRUE(circle);
        EXPECT_NEAR(glm::length(circle->u), glm::length(circle->v), 1e-9);
    }
}

TEST(PlaneSection, ToriAreCutInCirclesAcrossTheirAxisAndAlongIt) {
    const auto outer = cut(torus, {0, 0, 3}, {0, 0, 1}, {0.3, 0.6});
    const auto inner = cut(torus, {0, 0, 3}, {0, 0, 1}, {0.3, 2.6});
    ASSERT_TRUE(outer && inner);
    EXPECT_NEAR(glm::length(outer->u), 48, 1e-9); // 2 (20 + 4)
    EXPECT_NEAR(glm::length(inner->u), 32, 1e-9);
    const auto tube = cut(torus, {0, 0, 0}, {1, 1, 0}, {2.3, 0.6});
    ASSERT_TRUE(tube);
    EXPECT_NEAR(glm::length(tube->u), 10, 1e-9);
    EXPECT_FALSE(cut(torus, {1, 0, 0}, {1, 0, 0}, {0.3, 0.6}));
    EXPECT_FALSE(cut(torus, {0, 0, 0}, {1, 0, 1}, {0.3, 0.6}));
}

TEST(PlaneSection, PlacesThatAreLargerAlongOneAxisHaveNone) {
    PlacedSurface place;
    place.model_from_shape = glm::dmat4x3{glm::scale(glm::dmat4{1}, glm::dvec3{1, 2, 1})};
    EXPECT_FALSE(plane_section(cylinder, cylinder, place, {0, 0, 3}, {0.3, 0.4, 1}, {0.3, 2}));
}

// A barrel, whose curve is a B-spline.
TEST(PlaneSection, AnySurfaceOfRevolutionIsCutInACircleAcrossItsAxis) {
    SurfaceShape barrel{.axis = axis};
    barrel.curve.kind = SurfaceCurve::Kind::spline;
    barrel.curve.along = {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}};
    barrel.curve.poles = {{5, 0, 0, 1}, {8, 0, 4, 1}, {4, 0, 10, 1}};
    const PlacedSurface place = placed();
    const glm::dvec3 height = place.model_from_shape * glm::dvec4{0, 0, 6, 1};
    const auto circle =
        plane_section(barrel, barrel, place, height, place.model_from_shape[2], {1, 0.4});
    ASSERT_TRUE(circle);
    // The place of the curve at that height, where 2 t^2 + 8 t = 6.
    const glm::dvec3 on = evaluate(barrel, {0, std::sqrt(7.0) - 2}).at;
    ASSERT_NEAR(on.z, 6, 1e-12);
    EXPECT_NEAR(glm::length(circle->u), 2 * on.x, 1e-9);
    EXPECT_NEAR(glm::distance(circle->point, height), 0, 1e-9);
}

TEST(PlaneSection, CylindersAlongTheAxisAndConesThroughItAreCutInLines) {
    const PlacedSurface place = placed();
    const auto is_straight = [&](const SurfaceShape& shape, glm::dvec3 point, glm::dvec3 normal) {
        const glm::dmat3 axes{place.model_from_shape};
        return is_cut_straight(shape, place, place.model_from_shape * glm::dvec4{point, 1},
                               axes * normal);
    };
    EXPECT_TRUE(is_straight(cylinder, {3, 0, 0}, {1, 0, 0}));
    EXPECT_FALSE(is_straight(cylinder, {3, 0, 0}, {1, 0, 0.1}));
    EXPECT_TRUE(is_straight(cone, {0, 0, 3}, {1, 2, 0}));
    EXPECT_FALSE(is_straight(cone, {1, 0, 3}, {1, 0, 0}));
    EXPECT_TRUE(is_straight(turned_line({5, 0, 2}, {1, 0, 0}), {1, 0, 0}, {1, 0, 1})); // a disc
    EXPECT_FALSE(is_straight(ball, {0, 0, 2}, {1, 0, 0}));
}

TEST(PlaneSection, TwoSurfacesMeetOnAPlane) {
    const PlacedSurface place = placed();
    const glm::dmat3 axes{place.model_from_shape};
    const glm::dvec3 point = place.model_from_shape * glm::dvec4{1.5, 0, 0, 1},
                     normal = glm::normalize(axes * glm::dvec3{1, 0, 0});
    // A cone and a ball, near to where both have x = 1.5.
    const auto met = place_on_both(cone, place, {1.2, 5}, ball, place, {1.2, 1}, point, normal);
    ASSERT_TRUE(met);
    EXPECT_NEAR(glm::dot(*met - point, normal), 0, 1e-9);
    EXPECT_TRUE(holds_place(cone, place, *met, 1e-9));
    EXPECT_TRUE(holds_place(ball, place, *met, 1e-9));
    // It is one curve, which does not cross itself.
    EXPECT_FALSE(place_on_both(ball, place, {1.2, 1}, ball, place, {1.2, 1}, point, normal));
}

} // namespace
} // namespace lineatlas
