// Cubic curves through points of smooth lines, and their form in files.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "vector/cubic_fitting.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using Points = std::vector<glm::dvec2>;

template <class Curve>
Points sample(const Curve& curve, int count) {
    Points points;
    for (int i = 0; i <= count; ++i) points.push_back(curve(static_cast<double>(i) / count));
    return points;
}

glm::dvec2 on_ellipse(double t) {
    const double angle = 2 * std::numbers::pi * t;
    return {100 + 80 * std::cos(angle), 100 + 30 * std::sin(angle)};
}

glm::dvec2 at(const Points& points, const FittedCubic& one, double t) {
    const double s = 1 - t;
    return s * s * s * points[one.first] + 3 * s * s * t * one.cubic.first_control +
           3 * s * t * t * one.cubic.last_control + t * t * t * points[one.last];
}

TEST(CubicFitting, FollowsACurveThatGoesRound) {
    Points points = sample(on_ellipse, 120);
    points.back() = points.front();
    const std::vector<FittedCubic> cubics = fit_cubics(points, true, 0.02);
    EXPECT_LE(cubics.size(), 12U);
    std::uint32_t end = 0;
    for (const FittedCubic& one : cubics) {
        EXPECT_EQ(one.first, end);
        end = one.last;
        for (double t = 0; t <= 1; t += 0.05) {
            const glm::dvec2 off = at(points, one, t) - glm::dvec2{100, 100};
            EXPECT_NEAR(std::hypot(off.x / 80, off.y / 30), 1, 0.05 / 30);
        }
    }
    EXPECT_EQ(end, 120U);
    // Each curve continues in the direction of the one before, also across the first point.
    for (std::size_t i = 0; i < cubics.size(); ++i) {
        const FittedCubic &one = cubics[i], &next = cubics[(i + 1) % cubics.size()];
        const glm::dvec2 came = glm::normalize(points[one.last] - one.cubic.last_control);
        const glm::dvec2 goes = glm::normalize(next.cubic.first_control - points[next.first]);
        EXPECT_LT(glm::distance(came, goes), 1e-9);
    }
}

TEST(CubicFitting, LeavesStraightLinesAndEndsAtCorners) {
    EXPECT_TRUE(fit_cubics(sample(
                               [](double t) {
                                   return glm::dvec2{10 * t, 20 * t};
                               },
                               8),
                           false, 0.02)
                    .empty());
    // A quarter of a circle, a corner, another quarter.
    Points points = sample(
        [](double t) {
            return 50.0 * glm::dvec2{std::cos(0.5 * std::numbers::pi * t),
                                     std::sin(0.5 * std::numbers::pi * t)};
        },
        20);
    for (const glm::dvec2 each : sample(
             [](double t) { // from there straight up
                 const double angle = std::numbers::pi * (1 - 0.5 * t);
                 return glm::dvec2{50, 50} + 50.0 * glm::dvec2{std::cos(angle), std::sin(angle)};
             },
             20))
        if (glm::distance(each, points.back()) > 1e-9) points.push_back(each);
    bool meets_corner = false;
    for (const FittedCubic& one : fit_cubics(points, false, 0.02)) {
        EXPECT_FALSE(one.first < 20 && one.last > 20);
        meets_corner = meets_corner || one.last == 20;
    }
    EXPECT_TRUE(meets_corner);
}

/// A straight line that continues as an arc stays straight.
TEST(CubicFitting, KeepsALongLineBesideAnArcStraight) {
    Points points{{-300, 50}};
    for (const glm::dvec2 each : sample(
             [](double t) {
                 return 50.0 *
                        glm::dvec2{std::sin(std::numbers::pi * t), std::cos(std::numbers::pi * t)};
             },
             40))
        points.push_back(each);
    for (const FittedCubic& one : fit_cubics(points, false, 0.02)) EXPECT_GE(one.first, 1U);
}

VectorDrawing bent_line() {
    test::Lines lines;
    lines.add(LineKind::crease, {{10, 90, 0.5}, {40, 70, 0.5}, {70, 80, 0.5}, {90, 80, 0.5}},
              false);
    test::Cuts cuts{lines.set, test::flat_camera()};
    cuts.add_all();
    VectorDrawing drawing =
        make_vector_drawing(lines.set, test::flat_camera(), cuts.intervals, Style{}, {});
    drawing.paths.at(0).curves = {
        {.first = 0, .last = 2, .cubic = VectorCubic{{20, 30}, {50, 40}}}};
    return drawing;
}

TEST(Cubics, AreWrittenAsCurves) {
    const VectorDrawing drawing = bent_line();
    const std::string svg = to_svg(drawing, {});
    EXPECT_NE(svg.find("m10 10c10 20 40 30 60 10h20"), svg.npos) << svg;
    EXPECT_EQ(to_svg(drawing, {.curves = false}).find("c10 20"), svg.npos);
    const std::string json = to_json(drawing, {});
    EXPECT_NE(json.find("\"controls\":[[20.0,30.0],[50.0,40.0]]"), std::string::npos) << json;
    const std::string dxf = to_dxf(drawing, {});
    const std::size_t spline = dxf.find("SPLINE");
    ASSERT_NE(spline, dxf.npos);
    EXPECT_NE(dxf.find("LINE", spline + 6), dxf.npos); // the straight part after the curve
    EXPECT_EQ(to_dxf(drawing, {.curves = false}).find("SPLINE"), std::string::npos);
}

} // namespace
} // namespace lineatlas
