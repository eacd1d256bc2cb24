// Circles that a mesh was cut from, and polygons that are meant as such.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "vector/mesh_circles.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using test::Cuts;
using test::Lines;

constexpr double pi = std::numbers::pi;
constexpr glm::dvec3 center{100, 50, 0.5};

/// Corners along an ellipse about `center`.
std::vector<glm::vec3> corners(int count, double from, double to, glm::dvec3 u = {40, 0, 0},
                               glm::dvec3 v = {0, 40, 0}) {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= count; ++i) {
        const double t = from + (to - from) * i / count;
        points.emplace_back(center + std::cos(t) * u + std::sin(t) * v);
    }
    return points;
}

std::vector<glm::vec3> ring(int count, glm::dvec3 u = {40, 0, 0}, glm::dvec3 v = {0, 40, 0}) {
    std::vector<glm::vec3> points = corners(count, 0, 2 * pi, u, v);
    points.pop_back();
    return points;
}

Lines lines_of(const std::vector<glm::vec3>& points, bool closed) {
    Lines lines;
    lines.add(LineKind::crease, points, closed);
    return lines;
}

VectorDrawing drawn(const LineSet& lines, const std::vector<Interval>& intervals) {
    const Mesh mesh;
    return make_vector_drawing(lines, test::flat_camera(), intervals, Style{}, {.mesh = &mesh});
}

VectorDrawing drawn_whole(const LineSet& lines) {
    Cuts cuts{lines, test::flat_camera()};
    cuts.add_all();
    return drawn(lines, cuts.intervals);
}

std::size_t curves_of(const VectorDrawing& drawing) {
    std::size_t count = 0;
    for (const VectorPath& path : drawing.paths) count += path.curves.size();
    return count;
}

double sweep_of(const VectorDrawing& drawing) {
    double sweep = 0;
    for (const VectorPath& path : drawing.paths)
        for (const VectorCurve& curve : path.curves) sweep += std::abs(curve.arc.sweep);
    return sweep;
}

TEST(MeshCircles, ARingOfTwentyFourIsACircle) {
    for (const int sides : {24, 25, 32, 64, 128, 300}) {
        SCOPED_TRACE(sides);
        const VectorDrawing drawing = drawn_whole(lines_of(ring(sides), true).set);
        ASSERT_EQ(drawing.paths.size(), 1U);
        ASSERT_EQ(drawing.paths[0].curves.size(), 1U);
        const VectorArc& arc = drawing.paths[0].curves[0].arc;
        EXPECT_NEAR(arc.major.x, 40, 1e-4);
        EXPECT_NEAR(glm::distance(arc.center, glm::dvec2{100, 50}), 0, 1e-4);
        EXPECT_EQ(arc.ratio, 1);
        EXPECT_NEAR(std::abs(arc.sweep), 2 * pi, 1e-12);
        EXPECT_NE(to_dxf(drawing).find("CIRCLE\n"), std::string::npos);
        EXPECT_EQ(to_dxf(drawing, {.curves = false}).find("CIRCLE\n"), std::string::npos);
    }
}

TEST(MeshCircles, RingsOfFewerCornersArePolygons) {
    for (const int sides : {3, 4, 5, 6, 8, 12, 16, 20, 23})
        EXPECT_TRUE(MeshCircles{lines_of(ring(sides), true).set}.empty()) << sides;
}

/// In perspective, too.
TEST(MeshCircles, ATiltedOneIsAnEllipse) {
    View view;
    view.eye = {0, -3, 2};
    view.up = {0, 0, 1};
    std::vector<glm::vec3> points;
    for (int i = 0; i < 48; ++i)
        points.emplace_back(0.3 + std::cos(i * pi / 24), 0.2 + std::sin(i * pi / 24), 0);
    const Lines lines = lines_of(points, true);
    const Camera camera = make_camera(view, {800, 600}, {{-2, -2, -1}, {2, 2, 1}});
    Cuts cuts{lines.set, camera};
    cuts.add_all();
    const Mesh mesh;
    const VectorDrawing drawing =
        make_vector_drawing(lines.set, camera, cuts.intervals, Style{}, {.mesh = &mesh});
    ASSERT_EQ(curves_of(drawing), 1U);
    const VectorArc& arc = drawing.paths[0].curves[0].arc;
    const glm::dvec2 minor = arc.ratio * glm::dvec2{-arc.major.y, arc.major.x};
    for (const VectorPoint& point : drawing.paths[0].points) {
        const glm::dvec2 out = point.at - arc.center;
        EXPECT_NEAR(std::hypot(glm::dot(out, arc.major) / glm::dot(arc.major, arc.major),
                               glm::dot(out, minor) / glm::dot(minor, minor)),
                    1, 1e-5);
    }
    EXPECT_NE(to_dxf(drawing).find("ELLIPSE\n"), std::string::npos);
}

/// Within 0.0005 of the radius, what rounding of a file's digits leaves.
TEST(MeshCircles, CornersAreOnTheCircle) {
    for (const auto& [off, circles] : {std::pair{0.015F, true}, std::pair{0.05F, false}}) {
        std::vector<glm::vec3> points = ring(32);
        for (std::size_t i = 0; i < points.size(); i += 3) points[i].z += off;
        EXPECT_EQ(MeshCircles{lines_of(points, true).set}.empty(), !circles) << off;
    }
}

TEST(MeshCircles, EllipsesSpiralsAndHelicesAreNoCircles) {
    for (const double ratio : {0.5, 0.9, 0.98})
        for (const int sides : {48, 120, 500})
            EXPECT_TRUE(MeshCircles{lines_of(ring(sides, {40, 0, 0}, {0, 40 * ratio, 0}), true).set}
                            .empty())
                << ratio << ' ' << sides;
    std::vector<glm::vec3> spiral = corners(64, 0, 2 * pi), helix = spiral;
    for (std::size_t i = 0; i < spiral.size(); ++i) {
        const float share = static_cast<float>(i) / 64;
        spiral[i] += 0.2F * share * (spiral[i] - glm::vec3{center});
        helix[i].z += 10 * share;
    }
    EXPECT_TRUE(MeshCircles{lines_of(spiral, false).set}.empty());
    EXPECT_TRUE(MeshCircles{lines_of(helix, false).set}.empty());
    std::vector<glm::vec3> uneven = ring(48);
    uneven.erase(uneven.begin() + 1);
    for (std::size_t i = 3; i < uneven.size(); i += 3) uneven.erase(uneven.begin() + i);
    EXPECT_TRUE(MeshCircles{lines_of(uneven, true).set}.empty());
}

/// Whether both ends of a segment are on its circle.
bool is_on_its_circle(const LineSet& lines, std::uint32_t segment, const MeshCircles& circles) {
    const EdgeCurve& circle = circles.circle(circles.circle_of(segment));
    const double radius = glm::length(circle.u);
    const auto is_on = [&](std::uint32_t end) {
        const glm::dvec3 at{lines.vertices[end]};
        return std::abs(glm::distance(at, circle.center) - radius) < 0.001 * radius;
    };
    return is_on(lines.segments[segment].p) && is_on(lines.segments[segment].q);
}

/// Half a circle or ellipse on its base line, from any of its segments on.
TEST(MeshCircles, ArcsKeepToTheirCircles) {
    for (const auto& [height, chords] : {std::pair{1.0, 48U}, std::pair{0.8, 0U}}) {
        std::vector<glm::vec3> loop;
        for (int k = 0; k <= 48; ++k)
            loop.emplace_back(std::cos(k * pi / 48), height * std::sin(k * pi / 48), 0);
        for (std::size_t start = 0; start < loop.size(); ++start) {
            SCOPED_TRACE(start);
            const Lines lines = lines_of(loop, true);
            const MeshCircles circles{lines.set};
            std::uint32_t found = 0;
            for (std::uint32_t i = 0; i < loop.size(); ++i) {
                if (circles.circle_of(i) == MeshCircles::none) continue;
                ++found;
                EXPECT_TRUE(is_on_its_circle(lines.set, i, circles)) << i;
            }
            EXPECT_EQ(found, chords);
            const auto base = static_cast<std::uint32_t>(loop.size() - 1 - start);
            EXPECT_EQ(circles.circle_of(base), MeshCircles::none);
            std::rotate(loop.begin(), loop.begin() + 1, loop.end());
        }
    }
}

/// A plate with round corners, from any of its own on.
TEST(MeshCircles, RoundCornersAreArcsBetweenLines) {
    std::vector<glm::vec3> plate;
    const std::vector<std::pair<double, double>> middles{
        {20, 20}, {-20, 20}, {-20, -20}, {20, -20}};
    for (std::size_t k = 0; k < 4; ++k)
        for (const glm::vec3 p :
             corners(8, 0.5 * pi * static_cast<double>(k), 0.5 * pi * static_cast<double>(k + 1),
                     {10, 0, 0}, {0, 10, 0}))
            plate.push_back(p + glm::vec3{middles[k].first, middles[k].second, 0});
    for (std::size_t start = 0; start < plate.size(); start += 5) {
        SCOPED_TRACE(start);
        std::rotate(plate.begin(), plate.begin() + 5, plate.end());
        const VectorDrawing drawing = drawn_whole(lines_of(plate, true).set);
        ASSERT_EQ(drawing.paths.size(), 1U);
        ASSERT_EQ(curves_of(drawing), 4U);
        for (const VectorCurve& curve : drawing.paths[0].curves) {
            EXPECT_NEAR(std::abs(curve.arc.sweep), pi / 2, 1e-5);
            EXPECT_NEAR(curve.arc.major.x, 10, 1e-4);
        }
        EXPECT_EQ(test::flaws_of(drawing), "");
    }
}

/// Short ones, as where another body cuts a circle, belong to it.
TEST(MeshCircles, AnArcMayEndWithinAChord) {
    std::vector<glm::vec3> points = corners(16, 0, pi);
    points.insert(points.begin(), corners(1, -0.05, 0)[0]);
    const VectorDrawing drawing = drawn_whole(lines_of(points, false).set);
    ASSERT_EQ(curves_of(drawing), 1U);
    EXPECT_NEAR(sweep_of(drawing), pi + 0.05, 1e-5);
}

/// As of a prism whose sides are lines.
TEST(MeshCircles, CornersWithOtherLinesStay) {
    Lines lines = lines_of(ring(32), true);
    for (const glm::vec3 corner : ring(32))
        lines.add(LineKind::crease, {corner, corner + glm::vec3{0, 0, 0.4F}});
    EXPECT_TRUE(MeshCircles{lines.set}.empty());
}

TEST(MeshCircles, SeveralSegmentsMayBeOneChord) {
    std::vector<glm::vec3> points;
    const std::vector<glm::vec3> polygon = ring(32);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        points.push_back(polygon[i]);
        if (i % 3 == 0) points.push_back(0.5F * (polygon[i] + polygon[(i + 1) % 32]));
    }
    const VectorDrawing drawing = drawn_whole(lines_of(points, true).set);
    ASSERT_EQ(curves_of(drawing), 1U);
    EXPECT_NEAR(sweep_of(drawing), 2 * pi, 1e-12);
    EXPECT_EQ(test::flaws_of(drawing), "");
}

/// Lines that end at the middle of a chord leave it whole, up to 14: with its halves 16 meet there.
TEST(MeshCircles, NoChordGoesOnOverTheTipOfAFan) {
    std::vector<glm::vec3> points = corners(5, 0, 5 * pi / 12);
    const glm::vec3 middle = 0.5F * (points[2] + points[3]);
    points.insert(points.begin() + 3, middle);
    for (const auto& [spokes, circles] : {std::pair{14, true}, std::pair{15, false}}) {
        Lines lines = lines_of(points, false);
        for (int i = 0; i < spokes; ++i)
            lines.add(LineKind::crease, {middle, middle + glm::vec3{i, 1, 9}});
        EXPECT_EQ(MeshCircles{lines.set}.empty(), !circles) << spokes;
    }
}

/// Its cost is not the square of its lines.
TEST(MeshCircles, AFanOfManyLinesHasNone) {
    constexpr std::uint32_t count = 20'000;
    LineSet fan;
    fan.vertices.emplace_back(0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double turn = 2 * pi * i / count;
        fan.vertices.emplace_back(std::cos(turn), std::sin(turn), 0);
        fan.segments.push_back({.p = 0,
                                .q = i + 1,
                                .face_a = LA_NO_FACE,
                                .face_b = LA_NO_FACE,
                                .from_start = 0,
                                .to_end = 0,
                                .path = i,
                                .tag = LA_KIND_CREASE});
    }
    EXPECT_TRUE(MeshCircles{fan}.empty());
}

/// What is seen of a chord ends where it did, and is straight.
TEST(MeshCircles, EndsStay) {
    const Lines lines = lines_of(ring(24), true);
    Cuts cuts{lines.set, test::flat_camera()};
    cuts.add(3, 0.5F, 1, true);
    for (std::uint32_t i = 4; i < 9; ++i) cuts.add(i, 0, 1, true);
    cuts.add(9, 0, 0.25F, true);
    const VectorDrawing drawing = drawn(lines.set, cuts.intervals);
    ASSERT_EQ(drawing.paths.size(), 1U);
    const VectorPath& path = drawing.paths[0];
    ASSERT_EQ(path.curves.size(), 1U);
    EXPECT_EQ(path.curves[0].first, 1U);
    EXPECT_EQ(path.curves[0].last + 2, path.points.size());
    EXPECT_NEAR(std::abs(path.curves[0].arc.sweep), 5 * pi / 12, 1e-5);
    const auto on_chord = [&](std::size_t i, double share) {
        const std::vector<glm::vec3> all = ring(24);
        const glm::dvec3 at = glm::mix(glm::dvec3{all[i]}, glm::dvec3{all[i + 1]}, share);
        return glm::dvec2{at.x, 100 - at.y};
    };
    EXPECT_LT(glm::distance(path.points.front().at, on_chord(3, 0.5)), 1e-4);
    EXPECT_LT(glm::distance(path.points.back().at, on_chord(9, 0.25)), 1e-4);
}

/// A line that ends on a chord still meets it.
TEST(MeshCircles, AChordThatIsMetStays) {
    const std::vector<glm::vec3> polygon = ring(24);
    const glm::vec3 middle = 0.5F * (polygon[5] + polygon[6]);
    for (const LineKind kind : {LineKind::crease, LineKind::hatching}) {
        Lines lines = lines_of(polygon, true);
        lines.add(kind, {middle + glm::vec3{0, 9, 0.2F}, middle + glm::vec3{0, 0, 0.2F}});
        const VectorDrawing drawing = drawn_whole(lines.set);
        const bool is_met = kind == LineKind::crease;
        EXPECT_NEAR(sweep_of(drawing), is_met ? 23 * pi / 12 : 2 * pi, 1e-5);
        EXPECT_EQ(test::flaws_of(drawing), "");
    }
}

/// One line is drawn of both: along the chord, which is near both.
TEST(MeshCircles, AChordThatAnotherLineRunsAlongStays) {
    const std::vector<glm::vec3> polygon = ring(24);
    Lines lines = lines_of(polygon, true);
    lines.add(LineKind::crease,
              {polygon[5] + glm::vec3{0, 0, 0.2F}, polygon[6] + glm::vec3{0, 0, 0.2F}});
    EXPECT_NEAR(sweep_of(drawn_whole(lines.set)), 23 * pi / 12, 1e-5);
    // Of the same circle it is the arc.
    Lines rims = lines_of(polygon, true);
    std::vector<glm::vec3> lower = polygon;
    for (glm::vec3& corner : lower) corner.z += 0.2F;
    rims.add(LineKind::crease, lower, true);
    const VectorDrawing drawing = drawn_whole(rims.set);
    EXPECT_EQ(drawing.paths.size(), 1U);
    EXPECT_NEAR(sweep_of(drawing), 2 * pi, 1e-12);
}

} // namespace
} // namespace lineatlas
