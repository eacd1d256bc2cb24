#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "vector/chaining.hpp"
#include "vector/paths.hpp"
#include "vector/pieces.hpp"
#include "vector/simplify.hpp"
#include "vector/strips.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using test::Cuts;
using test::flat_camera;
using test::Lines;

constexpr double rounding = 1e-4; // pixels, of matrices in floats

void expect_at(glm::dvec2 at, glm::dvec2 expected) {
    EXPECT_NEAR(at.x, expected.x, rounding);
    EXPECT_NEAR(at.y, expected.y, rounding);
}

std::vector<VectorPath> chained(const Lines& lines, const Cuts& cuts) {
    Pieces pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    drop_flickers(pieces);
    return chain_strips(lines.set, pieces, make_strips(lines.set, pieces), nullptr);
}

TEST(VectorChains, APathIsOnePolyline) {
    Lines lines;
    lines.add(LineKind::crease, {{10, 10, 0}, {50, 10, 0}, {50, 60, 0}, {90, 80, 0}});
    Cuts cuts{lines.set, flat_camera()};
    cuts.add_all();
    const std::vector<VectorPath> paths = chained(lines, cuts);
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_FALSE(paths[0].closed);
    ASSERT_EQ(paths[0].points.size(), 4U);
    expect_at(paths[0].points[2].at, {50, 40});
    ASSERT_EQ(paths[0].pieces.size(), 3U);
    EXPECT_EQ(paths[0].pieces[1].source.from, 1001U);
    EXPECT_EQ(paths[0].pieces[1].source.to, 1002U);
    EXPECT_NEAR(paths[0].points.front().arc, -paths[0].points.back().arc, 1e-3);
}

TEST(VectorChains, AClosedPathClosesAndOneThatIsHiddenInPartIsWholeAcrossItsSeam) {
    Lines lines;
    lines.add(LineKind::crease, {{10, 10, 0}, {90, 10, 0}, {90, 60, 0}, {10, 60, 0}}, true);
    Cuts whole{lines.set, flat_camera()};
    whole.add_all();
    const std::vector<VectorPath> loop = chained(lines, whole);
    ASSERT_EQ(loop.size(), 1U);
    EXPECT_TRUE(loop[0].closed);
    EXPECT_EQ(loop[0].points.size(), 5U);
    EXPECT_EQ(loop[0].points.front().at, loop[0].points.back().at);

    Cuts cuts{lines.set, flat_camera()};
    cuts.add(0, 0, 1, true);
    cuts.add(1, 0, 0.5F, true);
    cuts.add(1, 0.5F, 1, false);
    cuts.add(2, 0, 1, true);
    cuts.add(3, 0, 1, true);
    std::vector<VectorPath> paths = chained(lines, cuts);
    ASSERT_EQ(paths.size(), 2U);
    std::ranges::sort(paths, {}, &VectorPath::visible);
    EXPECT_EQ(paths[0].points.size(), 2U);
    EXPECT_EQ(paths[1].points.size(), 5U);
    EXPECT_FALSE(paths[1].closed);
    expect_at(paths[1].points.front().at, {90, 40});
}

// A part of the loop is outline; the rest goes on across the loop's seam.
TEST(VectorChains, ALoopOfTwoPensIsTwoPaths) {
    Lines lines;
    lines.add(LineKind::crease, {{10, 10, 0}, {90, 10, 0}, {90, 60, 0}, {10, 60, 0}}, true);
    Cuts cuts{lines.set, flat_camera()};
    cuts.add_all();
    const Pieces pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    std::vector<Strip> strips = make_strips(lines.set, pieces);
    ASSERT_EQ(strips.size(), 1U);
    strips[0].outlines = {{100, 150}};
    Style style;
    style.pens = {{.match = {.kinds = {"outline"}}, .width = 3.0F}};
    const LineClasses classes = line_classes(lines.set);
    const LinePens pens = line_pens(classes, style);
    const PathPens by_rule{classes, pens};
    std::vector<VectorPath> paths = chain_strips(lines.set, pieces, strips, &by_rule);
    ASSERT_EQ(paths.size(), 2U);
    std::ranges::sort(paths, {}, &VectorPath::outline);
    EXPECT_NEAR(length_of(paths[0]), 210, 1e-3);
    EXPECT_NEAR(length_of(paths[1]), 50, 1e-3);
    EXPECT_FALSE(paths[0].closed);
    EXPECT_EQ(paths[0].points.front().at, paths[1].points.back().at);
    EXPECT_EQ(paths[0].points.back().at, paths[1].points.front().at);
}

TEST(VectorChains, SilhouettesOfAMeshBecomeLoops) {
    Lines lines;
    // Edges of a hexagon, in no order and any direction, and a spur.
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 6; ++i) {
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / 3;
        corners.emplace_back(100 + 30 * std::cos(angle), 50 + 30 * std::sin(angle), 0);
    }
    for (const auto& [p, q] : {std::pair{0, 1}, {3, 2}, {4, 5}, {1, 2}, {0, 5}, {4, 3}}) {
        lines.add(LineKind::silhouette,
                  {corners[static_cast<std::size_t>(p)], corners[static_cast<std::size_t>(q)]});
    }
    lines.add(LineKind::silhouette, {corners[0], {100, 50, 0}});
    lines.add(LineKind::crease, {corners[3], {20, 50, 0}});
    Cuts cuts{lines.set, flat_camera()};
    cuts.add_all();
    const std::vector<VectorPath> paths = chained(lines, cuts);
    ASSERT_EQ(paths.size(), 3U);
    const auto loop = std::ranges::find(paths, true, &VectorPath::closed);
    ASSERT_NE(loop, paths.end());
    EXPECT_EQ(loop->points.size(), 7U);
    EXPECT_NEAR(length_of(*loop), 180, 1e-3);
    EXPECT_NEAR(loop->points.back().arc, 90, 1e-3);
    // Tags point along the path.
    for (std::size_t i = 1; i < loop->pieces.size(); ++i) {
        EXPECT_EQ(loop->pieces[i - 1].source.to, loop->pieces[i].source.from);
    }
}

TEST(VectorChains, VisibleAndHiddenPiecesAreNeverOnePath) {
    Lines lines;
    lines.add(LineKind::silhouette, {{10, 10, 0}, {50, 10, 0}});
    lines.add(LineKind::silhouette, {{50, 10, 0}, {90, 10, 0}});
    Cuts cuts{lines.set, flat_camera()};
    cuts.add(0, 0, 0.5F, true);
    cuts.add(0, 0.5F, 1, false);
    cuts.add(1, 0, 1, true);
    EXPECT_EQ(chained(lines, cuts).size(), 3U);
}

TEST(VectorChains, AFlickerOfVisibilityDoesNotTearAPath) {
    Lines lines;
    lines.add(LineKind::crease, {{10, 10, 0}, {110, 10, 0}});
    Cuts cuts{lines.set, flat_camera()};
    cuts.add(0, 0, 0.5F, true);
    cuts.add(0, 0.5F, 0.5F, false);
    cuts.add(0, 0.5F, 0.50005F, true);
    cuts.add(0, 0.50005F, 0.5001F, false);
    cuts.add(0, 0.5001F, 1, true);
    const std::vector<VectorPath> paths = chained(lines, cuts);
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_NEAR(length_of(paths[0]), 100, 1e-3);
}

TEST(Simplify, PointsOnALineGoAndCornersStay) {
    VectorPath path = path_through(LineKind::crease, true,
                                   {{0, 0}, {10, 0.04}, {20, 0}, {30, 0}, {30, 20}, {30, 21}});
    simplify(path, 0.05);
    ASSERT_EQ(path.points.size(), 3U);
    EXPECT_EQ(path.points[1].at, (glm::dvec2{30, 0}));
    ASSERT_EQ(path.pieces.size(), 5U);
    EXPECT_EQ(path.pieces[2].point, 0U);
    EXPECT_EQ(path.pieces[2].segment, 2U);
    EXPECT_EQ(path.pieces[3].point, 1U);
    VectorPath exact = path_through(LineKind::crease, true, {{0, 0}, {10, 0.06}, {20, 0}});
    simplify(exact, 0.05);
    EXPECT_EQ(exact.points.size(), 3U);
}

TEST(Simplify, ACircleStaysWithinTheTolerance) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 720; ++i) {
        const double angle = i * std::numbers::pi / 360;
        points.emplace_back(100 + 80 * std::cos(angle), 50 + 80 * std::sin(angle));
    }
    points.push_back(points.front());
    VectorPath path = path_through(LineKind::crease, true, points);
    simplify(path, 0.05);
    EXPECT_LT(path.points.size(), 130U);
    EXPECT_TRUE(path.closed);
    EXPECT_EQ(path.points.front().at, path.points.back().at);
    for (const glm::dvec2 point : points) {
        double nearest = 1e9;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const glm::dvec2 a = path.points[i - 1].at;
            const glm::dvec2 way = path.points[i].at - a;
            const double share =
                std::clamp(glm::dot(point - a, way) / glm::dot(way, way), 0.0, 1.0);
            nearest = std::min(nearest, glm::distance(point, a + way * share));
        }
        EXPECT_LE(nearest, 0.05 + 1e-9);
    }
}

TEST(Simplify, SpecksVanish) {
    std::vector<VectorPath> paths{
        path_through(LineKind::crease, true, {{5, 5}, {5.004, 5}, {5.004, 5.004}}),
        path_through(LineKind::crease, true, {{5, 5}, {5.02, 5}})};
    simplify(paths, 0.05, PathCurves{LineSet{}, nullptr, {}});
    EXPECT_EQ(paths.size(), 1U);
}

} // namespace
} // namespace lineatlas
