// Edges that are round by their file: their visible parts in a drawing, and their form in files.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "lineatlas/error.hpp"
#include "lineatlas/vector.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using test::Cuts;
using test::Lines;

constexpr double pi = std::numbers::pi;
constexpr std::uint32_t first_position = 1000; // as Lines numbers them

/// Lines of a mesh that knows the curves of its edges.
class Round {
  public:
    /// An edge along a curve from one angle to another.
    void add_arc(const EdgeCurve& curve, double from, double to, int chords) {
        std::vector<glm::vec3> points;
        for (int i = 0; i <= chords; ++i)
            points.push_back(at(curve, from + (to - from) * i / chords));
        if (std::abs(to - from) > 2 * pi - 1e-9) points.back() = points.front();
        add(points, curve);
    }

    void add_straight(glm::vec3 from, glm::vec3 to) { add({from, to}, std::nullopt); }
    /// An edge along some other curve, through points of it.
    void add_through(const std::vector<glm::vec3>& points) { add(points, std::nullopt); }

    /// Makes one path of all edges so far.
    void end_path(bool closed) {
        if (closed) points_.pop_back();
        lines.add(LineKind::crease, points_, closed);
        points_.clear();
        mesh.positions.assign(first_position, glm::vec3{0});
        mesh.positions.insert(mesh.positions.end(), lines.set.vertices.begin(),
                              lines.set.vertices.end());
        mesh.known_edges.clear();
        for (const Known& known : known_)
            mesh.known_edges.push_back(
                {position(known.from), position(known.to), KnownEdge::Kind::sharp, known.edge});
    }

    static glm::vec3 at(const EdgeCurve& curve, double angle) {
        return curve.center + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
    }

    Lines lines;
    Mesh mesh;

  private:
    struct Known {
        glm::vec3 from, to;
        std::uint32_t edge;
    };

    void add(const std::vector<glm::vec3>& points, const std::optional<EdgeCurve>& curve) {
        const auto edge = static_cast<std::uint32_t>(mesh.edge_curves.size());
        mesh.edge_curves.push_back(curve);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            known_.push_back({points[i], points[i + 1], edge});
        if (!points_.empty()) points_.pop_back();
        points_.insert(points_.end(), points.begin(), points.end());
    }

    std::uint32_t position(glm::vec3 at) const {
        const auto& all = lines.set.vertices;
        return first_position +
               static_cast<std::uint32_t>(std::ranges::find(all, at) - all.begin());
    }

    std::vector<glm::vec3> points_;
    std::vector<Known> known_;
};

constexpr EdgeCurve circle{.center = {100, 50, 0.5}, .u = {40, 0, 0}, .v = {0, 40, 0}};
constexpr EdgeCurve ellipse{.center = {100, 50, 0.5}, .u = {40, 0, 0}, .v = {0, 20, 0.3}};

VectorDrawing drawn(const Round& round, const std::vector<Interval>& intervals,
                    const Camera& camera = test::flat_camera()) {
    return make_vector_drawing(round.lines.set, camera, intervals, Style{}, {.mesh = &round.mesh});
}

VectorDrawing drawn_whole(const Round& round, const Camera& camera = test::flat_camera()) {
    Cuts cuts{round.lines.set, camera};
    cuts.add_all();
    return drawn(round, cuts.intervals, camera);
}

/// A left and a right half circle with the lines between them. The loop begins at an angle of the
/// right half.
Round stadium(double radius, double begins) {
    const auto half = [&](double x) {
        return EdgeCurve{.center = {x, 50, 0.5}, .u = {radius, 0, 0}, .v = {0, radius, 0}};
    };
    const EdgeCurve left = half(60), right = half(140);
    Round round;
    round.add_arc(right, begins, pi / 2, 12);
    round.add_straight(Round::at(right, pi / 2), Round::at(left, pi / 2));
    round.add_arc(left, pi / 2, 3 * pi / 2, 24);
    round.add_straight(Round::at(left, 3 * pi / 2), Round::at(right, 3 * pi / 2));
    if (begins > -pi / 2) round.add_arc(right, 3 * pi / 2, begins + 2 * pi, 12);
    round.end_path(true);
    return round;
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
    return found;
}

/// A closed line of the file, without a curve of its own.
Round loop_through(std::vector<glm::vec3> points) {
    points.push_back(points.front());
    Round round;
    round.add_through(points);
    round.end_path(true);
    return round;
}

// Their corners lie on a circle, but their sides do not.
TEST(Curves, PolygonsAreNoCircles) {
    for (const int corners : {4, 6, 8, 12, 20}) {
        SCOPED_TRACE(corners);
        std::vector<glm::vec3> points;
        for (int i = 0; i < corners; ++i) points.push_back(Round::at(circle, 2 * pi * i / corners));
        for (const VectorPath& path : drawn_whole(loop_through(points)).paths)
            for (const VectorCurve& curve : path.curves) EXPECT_TRUE(curve.cubic);
    }
    const VectorDrawing rectangle =
        drawn_whole(loop_through({{70, 30, 0.5}, {130, 30, 0.5}, {130, 70, 0.5}, {70, 70, 0.5}}));
    ASSERT_EQ(rectangle.paths.size(), 1U);
    EXPECT_TRUE(rectangle.paths[0].curves.empty());
}

TEST(Curves, ASuperellipseIsNoCircle) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < 64; ++i) {
        const double c = std::cos(2 * pi * i / 64), s = std::sin(2 * pi * i / 64);
        const double reach = 40 / std::sqrt(std::sqrt(c * c * c * c + s * s * s * s));
        points.emplace_back(100 + reach * c, 50 + reach * s, 0.5);
    }
    const VectorDrawing drawing = drawn_whole(loop_through(points));
    ASSERT_EQ(drawing.paths.size(), 1U);
    EXPECT_FALSE(drawing.paths[0].curves.empty());
    for (const VectorCurve& curve : drawing.paths[0].curves) EXPECT_TRUE(curve.cubic);
}

TEST(Curves, AWholeCircleIsOne) {
    Round round;
    round.add_arc(circle, 0, 2 * pi, 24);
    round.end_path(true);
    const VectorDrawing drawing = drawn_whole(round);
    ASSERT_EQ(drawing.paths.size(), 1U);
    ASSERT_EQ(drawing.paths[0].curves.size(), 1U);
    const VectorCurve& curve = drawing.paths[0].curves[0];
    EXPECT_EQ(curve.first, 0U);
    EXPECT_EQ(curve.last + 1, drawing.paths[0].points.size());
    EXPECT_NEAR(curve.arc.major.x, 40, 1e-4); // cameras are of floats
    EXPECT_EQ(curve.arc.ratio, 1);
    EXPECT_NEAR(std::abs(curve.arc.sweep), 2 * pi, 1e-12);
    EXPECT_EQ(count(to_dxf(drawing), "CIRCLE\n"), 1U);
    EXPECT_EQ(count(to_dxf(drawing, {.curves = false}), "CIRCLE\n"), 0U);
    EXPECT_NE(to_svg(drawing).find(" 40 40 0"), std::string::npos);
    EXPECT_NE(to_json(drawing).find("\"curves\":[{\"points\":[0,"), std::string::npos);
}

TEST(Curves, EndsLieOnTheCurve) {
    for (const EdgeCurve& curve : {circle, ellipse}) {
        Round round;
        round.add_arc(curve, 0, 2 * pi, 24);
        round.end_path(true);
        Cuts cuts{round.lines.set, test::flat_camera()};
        cuts.add(3, 0.5F, 1, true);
        for (std::uint32_t i = 4; i < 9; ++i) cuts.add(i, 0, 1, true);
        cuts.add(9, 0, 0.5F, true);
        const VectorDrawing drawing = drawn(round, cuts.intervals);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const VectorPath& path = drawing.paths[0];
        ASSERT_EQ(path.curves.size(), 1U);
        const VectorArc& arc = path.curves[0].arc;
        EXPECT_NEAR(std::abs(arc.sweep), 6 * pi / 12, 1e-5);
        const glm::dvec2 minor = arc.ratio * glm::dvec2{-arc.major.y, arc.major.x};
        for (const VectorPoint& end : {path.points.front(), path.points.back()}) {
            const glm::dvec2 out = end.at - arc.center;
            const double along = glm::dot(out, arc.major) / glm::dot(arc.major, arc.major);
            const double across = glm::dot(out, minor) / glm::dot(minor, minor);
            EXPECT_NEAR(std::hypot(along, across), 1, 1e-9);
        }
        const bool round_seen = arc.ratio == 1;
        EXPECT_EQ(count(to_dxf(drawing), "ARC\n"), round_seen ? 1U : 0U);
        EXPECT_EQ(count(to_dxf(drawing), "ELLIPSE\n"), round_seen ? 0U : 1U);
    }
}

TEST(Curves, WholeEllipsesAreOneEntity) {
    Round round;
    round.add_arc(ellipse, 0, 2 * pi, 48);
    round.end_path(true);
    const VectorDrawing drawing = drawn_whole(round);
    ASSERT_EQ(drawing.paths.size(), 1U);
    ASSERT_EQ(drawing.paths[0].curves.size(), 1U);
    EXPECT_NEAR(drawing.paths[0].curves[0].arc.ratio, 0.5, 1e-6);
    const std::string dxf = to_dxf(drawing);
    EXPECT_EQ(count(dxf, "ELLIPSE\n"), 1U);
    EXPECT_EQ(count(dxf, "POLYLINE\n"), 0U);
}

/// Halves of one circle are one curve. A loop does not begin within a curve.
TEST(Curves, AStadiumIsTwoArcsAndTwoLines) {
    const Round round = stadium(30, 0);
    const VectorDrawing drawing = drawn_whole(round);
    ASSERT_EQ(drawing.paths.size(), 1U);
    const VectorPath& path = drawing.paths[0];
    EXPECT_TRUE(path.closed);
    ASSERT_EQ(path.curves.size(), 2U);
    for (const VectorCurve& curve : path.curves) {
        EXPECT_NEAR(std::abs(curve.arc.sweep), pi, 1e-5);
        EXPECT_NEAR(curve.arc.major.x, 30, 1e-4);
    }
    EXPECT_EQ(test::flaws_of(drawing), "");
    const std::string dxf = to_dxf(drawing);
    EXPECT_EQ(count(dxf, "LWPOLYLINE\n"), 1U);
    EXPECT_EQ(count(dxf, " 42\n"), 2 + count(to_dxf(drawing, {.curves = false}), " 42\n"));
}

/// Even in small drawings the point between an arc and a line stays, although it is no corner.
TEST(Curves, TangentPointsStay) {
    const Round round = stadium(3, -pi / 2);
    const VectorDrawing drawing = drawn_whole(round);
    ASSERT_EQ(drawing.paths.size(), 1U);
    ASSERT_EQ(drawing.paths[0].curves.size(), 2U);
    for (const VectorCurve& curve : drawing.paths[0].curves)
        EXPECT_NEAR(std::abs(curve.arc.sweep), pi, 1e-5);
}

/// Two half ellipses that meet on one axis are no ellipse.
TEST(Curves, AnEggIsTwoHalves) {
    const EdgeCurve blunt{.center = {100, 50, 0.5}, .u = {20, 0, 0}, .v = {0, 15, 0}};
    const EdgeCurve pointed{.center = {100, 50, 0.5}, .u = {40, 0, 0}, .v = {0, 15, 0}};
    Round round;
    round.add_arc(pointed, -pi / 2, pi / 2, 48);
    round.add_arc(blunt, pi / 2, 3 * pi / 2, 48);
    round.end_path(true);
    const VectorDrawing drawing = drawn_whole(round);
    ASSERT_EQ(drawing.paths.size(), 1U);
    EXPECT_EQ(drawing.paths[0].curves.size(), 2U);
    EXPECT_EQ(count(to_dxf(drawing), "ELLIPSE\n"), 2U);
}

TEST(Curves, InPerspectiveACircleIsAnEllipse) {
    View view;
    view.eye = {0, -3, 2};
    view.up = {0, 0, 1};
    const EdgeCurve unit{.center = {0.3, 0.2, 0}, .u = {1, 0, 0}, .v = {0, 1, 0}};
    Round round;
    round.add_arc(unit, 0, 2 * pi, 200);
    round.end_path(true);
    const Camera camera = make_camera(view, {800, 600}, {{-2, -2, -1}, {2, 2, 1}});
    const VectorDrawing drawing = drawn_whole(round, camera);
    ASSERT_EQ(drawing.paths.size(), 1U);
    ASSERT_EQ(drawing.paths[0].curves.size(), 1U);
    const VectorArc& arc = drawing.paths[0].curves[0].arc;
    const glm::dvec2 minor = arc.ratio * glm::dvec2{-arc.major.y, arc.major.x};
    const glm::dmat4 clip_from_world = glm::dmat4{camera.projection} * glm::dmat4{camera.view};
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 at =
            unit.center + std::cos(0.13 * i) * unit.u + std::sin(0.13 * i) * unit.v;
        const glm::dvec4 clip = clip_from_world * glm::dvec4{at, 1};
        const glm::dvec2 out =
            glm::dvec2{(1 + clip.x / clip.w) * 400, (1 - clip.y / clip.w) * 300} - arc.center;
        EXPECT_NEAR(std::hypot(glm::dot(out, arc.major) / glm::dot(arc.major, arc.major),
                               glm::dot(out, minor) / glm::dot(minor, minor)),
                    1, 1e-9);
    }
}

/// An edge that has moved since it was read has no known curve.
TEST(Curves, WhatIsNotOnItsCurveHasNone) {
    Round round;
    round.add_arc(circle, 0, 2 * pi, 24);
    round.end_path(true);
    round.mesh.edge_curves[0]->center.x += 1;
    const VectorDrawing drawing = drawn_whole(round);
    ASSERT_EQ(drawing.paths.size(), 1U);
    for (const VectorCurve& curve : drawing.paths[0].curves) EXPECT_TRUE(curve.cubic);
}

TEST(Curves, OfADrawingFitItsPaths) {
    VectorDrawing drawing;
    drawing.paths.push_back(
        {.points = {{}, {}}, .pieces = {}, .curves = {{.first = 0, .last = 2}}});
    EXPECT_THROW(to_svg(drawing), UsageError);
}

/// The height of a wave at x.
double wave(double x) {
    return 50 + 30 * std::sin((x - 20) * pi / 80);
}

/// The approximate distance of a point from the wave in pixels.
double off_wave(glm::dvec2 at) {
    const double slope = 30 * pi / 80 * std::cos((at.x - 20) * pi / 80);
    return std::abs(at.y - (100 - wave(at.x))) / std::hypot(1, slope);
}

Round round_wave(int chords) {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= chords; ++i) {
        const float x = 20 + 160.0F * static_cast<float>(i) / static_cast<float>(chords);
        points.emplace_back(x, wave(x), 0.5F);
    }
    Round round;
    round.add_through(points);
    round.end_path(false);
    return round;
}

TEST(Curves, ASplineRunsBetweenItsPoints) {
    const Round round = round_wave(36);
    double off_chords = 0;
    const std::vector<glm::vec3>& points = round.lines.set.vertices;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec3 middle = 0.5 * (glm::dvec3{points[i - 1]} + glm::dvec3{points[i]});
        off_chords = std::max(off_chords, off_wave({middle.x, 100 - middle.y}));
    }
    EXPECT_GT(off_chords, 0.1);
    const VectorDrawing drawing = drawn_whole(round);
    ASSERT_EQ(drawing.paths.size(), 1U);
    const VectorPath& path = drawing.paths[0];
    for (const VectorPoint& point : path.points) EXPECT_LT(off_wave(point.at), 0.01);
    ASSERT_FALSE(path.curves.empty());
    EXPECT_EQ(path.curves.front().first, 0U);
    EXPECT_EQ(path.curves.back().last + 1, path.points.size());
    EXPECT_LT(path.curves.size(), 12U);
    for (const VectorCurve& curve : path.curves) {
        ASSERT_TRUE(curve.cubic);
        const glm::dvec2 from = path.points[curve.first].at, to = path.points[curve.last].at;
        for (int i = 0; i <= 16; ++i) {
            const double t = i / 16.0, r = 1 - t;
            EXPECT_LT(off_wave(r * r * r * from + 3 * r * r * t * curve.cubic->first_control +
                               3 * r * t * t * curve.cubic->last_control + t * t * t * to),
                      0.03);
        }
    }
}

TEST(Curves, WhatIsSeenOfASplineEndsOnIt) {
    const Round round = round_wave(36);
    Cuts cuts{round.lines.set, test::flat_camera()};
    cuts.add(7, 0.5F, 1, true);
    cuts.add(8, 0, 1, true);
    cuts.add(9, 0, 0.5F, true);
    const VectorDrawing drawing = drawn(round, cuts.intervals);
    ASSERT_EQ(drawing.paths.size(), 1U);
    for (const VectorPoint& point : drawing.paths[0].points) EXPECT_LT(off_wave(point.at), 0.01);
}

/// A turn that is larger than those between a curve's chords is a corner, and so is a single turn.
TEST(Curves, CornersOfAnEdgeStay) {
    for (const double turn : {60.0, 10.0}) {
        const double slope = std::tan(turn * pi / 180);
        Round round;
        std::vector<glm::vec3> points;
        for (int x = 20; x <= 180; x += 20)
            points.emplace_back(x, 20 + (x > 100 ? slope * (x - 100) : 0.0), 0.5F);
        round.add_through(points);
        round.end_path(false);
        const VectorDrawing drawing = drawn_whole(round);
        ASSERT_EQ(drawing.paths.size(), 1U);
        for (const VectorPoint& point : drawing.paths[0].points) {
            const double x = point.at.x;
            EXPECT_NEAR(100 - point.at.y, 20 + (x > 100 ? slope * (x - 100) : 0.0), 1e-3);
        }
    }
}

} // namespace
} // namespace lineatlas
