#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "vector/arc_fitting.hpp"

namespace lineatlas {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr glm::dvec2 center{200, 150};

glm::dvec2 on_circle(double radius, double degrees) {
    return center + radius * glm::dvec2{std::cos(degrees * degree), std::sin(degrees * degree)};
}

/// Points of a circle from one angle to another, `step` degrees apart.
std::vector<OutlinePoint> along(double radius, double from, double to, double step) {
    std::vector<OutlinePoint> points;
    const int count = static_cast<int>(std::lround(std::abs(to - from) / step));
    for (int i = 0; i <= count; ++i)
        points.push_back({on_circle(radius, from + (to - from) * i / count)});
    return points;
}

Outline polygon(int sides, double radius) {
    Outline outline{.points = along(radius, 0, 360, 360.0 / sides), .closed = true};
    outline.points.pop_back();
    return outline;
}

TEST(Arcs, ARoundPolygonIsACircle) {
    for (const int sides : {12, 16, 64, 500}) {
        SCOPED_TRACE(sides);
        const Outline circle = fit_arcs(polygon(sides, 80));
        ASSERT_TRUE(circle.is_round());
        const VectorArc arc = arc_between(circle.points[0], circle.points[1].at);
        EXPECT_NEAR(glm::distance(arc.center, center), 0, 1e-9);
        EXPECT_NEAR(arc.major.x, 80, 1e-9);
        EXPECT_EQ(circle.points[0].bulge, 1);
    }
    Outline turned = polygon(32, 80);
    std::ranges::reverse(turned.points);
    EXPECT_EQ(fit_arcs(turned).points[0].bulge, -1);
}

TEST(Arcs, APolygonWithCornersIsNoCircle) {
    for (const int sides : {3, 4, 6, 8, 10}) {
        SCOPED_TRACE(sides);
        const Outline kept = fit_arcs(polygon(sides, 80));
        EXPECT_EQ(kept.points.size(), static_cast<std::size_t>(sides));
        for (const OutlinePoint& point : kept.points) EXPECT_EQ(point.bulge, 0);
    }
}

TEST(Arcs, PointsOffByMoreThanAFiftiethOfAPixelMakeNoArc) {
    std::mt19937 random{5};
    std::uniform_real_distribution<double> off{-1, 1};
    for (const double noise : {0.012, 0.08}) {
        Outline rough = polygon(48, 80);
        for (OutlinePoint& point : rough.points)
            point.at += noise * glm::dvec2{off(random), off(random)};
        EXPECT_EQ(fit_arcs(rough).is_round(), noise < 0.02) << noise;
    }
}

TEST(Arcs, AnEllipseIsNoCircle) {
    Outline ellipse = polygon(90, 1);
    for (OutlinePoint& point : ellipse.points) point.at = glm::dvec2{100, 60} * (point.at - center);
    for (const OutlinePoint& point : fit_arcs(ellipse).points) EXPECT_EQ(point.bulge, 0);
}

TEST(Arcs, AnOpenArcMayEndBetweenTwoPoints) {
    Outline cut{.points = along(80, 0, 180, 10)};
    // The line is hidden within its first and its last chord.
    cut.points.front().at = 0.5 * (cut.points[0].at + cut.points[1].at);
    const std::size_t last = cut.points.size() - 1;
    cut.points[last].at = 0.7 * cut.points[last - 1].at + 0.3 * cut.points[last].at;
    const Outline arc = fit_arcs(cut);
    ASSERT_EQ(arc.points.size(), 2U);
    const VectorArc found = arc_between(arc.points[0], arc.points[1].at);
    EXPECT_NEAR(glm::distance(found.center, center), 0, 1e-6);
    EXPECT_NEAR(found.major.x, 80, 1e-6);
    EXPECT_NEAR(found.from, 5 * degree, 1e-6);
    EXPECT_NEAR(found.sweep, 168 * degree, 0.02 * degree);
    // An end that lies outside the circle is no part of the circle.
    cut.points.front().at = on_circle(80.2, 5);
    EXPECT_GT(fit_arcs(cut).points.size(), 2U);
}

TEST(Arcs, ASlotHasTwoArcsWhereverItStarts) {
    Outline slot{.points = along(40, 90, 270, 7.5), .closed = true};
    for (OutlinePoint point : along(40, 270, 450, 7.5)) {
        point.at.x += 120;
        slot.points.push_back(point);
    }
    const std::size_t count = slot.points.size();
    for (std::size_t start = 0; start < count; start += 3) {
        SCOPED_TRACE(start);
        Outline turned = slot;
        std::ranges::rotate(turned.points,
                            turned.points.begin() + static_cast<std::ptrdiff_t>(start));
        const Outline found = fit_arcs(turned);
        ASSERT_EQ(found.points.size(), 4U);
        int arcs = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (found.points[i].bulge == 0) continue;
            ++arcs;
            EXPECT_NEAR(found.points[i].bulge, 1, 1e-9);
            EXPECT_NEAR(arc_between(found.points[i], found.points[(i + 1) % 4].at).major.x, 40,
                        1e-9);
        }
        EXPECT_EQ(arcs, 2);
    }
}

TEST(Arcs, ARoundedCornerBetweenStraightLines) {
    Outline corner{.points = along(20, 180, 270, 9)};
    corner.points.insert(corner.points.begin(), {on_circle(20, 180) + glm::dvec2{0, 100}});
    corner.points.push_back({on_circle(20, 270) + glm::dvec2{100, 0}});
    const Outline found = fit_arcs(corner);
    ASSERT_EQ(found.points.size(), 4U);
    EXPECT_EQ(found.points[0].bulge, 0);
    EXPECT_NEAR(found.points[1].bulge, std::tan(90 * degree / 4), 1e-9);
    EXPECT_EQ(found.points[2].bulge, 0);
}

TEST(Arcs, LongWaysTakeNoLongTime) {
    // 30,000 points near a circle, and as many on a curve in which every few points form an arc.
    std::mt19937 random{5};
    std::uniform_real_distribution<double> off{-0.1, 0.1};
    Outline rough, spiral;
    for (int i = 0; i < 30000; ++i) {
        rough.points.push_back({on_circle(800 + off(random), 0.1 * i)});
        spiral.points.push_back({on_circle(20 + 0.001 * i, 6.0 * i)});
    }
    EXPECT_EQ(fit_arcs(rough).points.size(), 30000U);
    EXPECT_LT(fit_arcs(spiral).points.size(), 30000U);
}

/// Two arcs longer than halves overlap, so they make no closed circle.
TEST(Arcs, ACircleIsTwoHalves) {
    const auto loop = [](double bulge) {
        return Outline{.points = {{{0, 0}, bulge}, {{1, 0}, bulge}}, .closed = true};
    };
    EXPECT_TRUE(loop(1).is_round());
    EXPECT_TRUE(loop(-1).is_round());
    EXPECT_FALSE(loop(2).is_round());
    EXPECT_FALSE(loop(0.5).is_round());
}

} // namespace
} // namespace lineatlas
