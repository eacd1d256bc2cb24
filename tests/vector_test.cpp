#include "lineatlas/vector.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/scenes.hpp"
#include "test_meshes.hpp"
#include "vector/chaining.hpp"
#include "vector/junctions.hpp"
#include "vector/overlaps.hpp"
#include "vector/paths.hpp"
#include "vector/pieces.hpp"
#include "vector/simplify.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using test::Cuts;
using test::flat_camera;
using test::Lines;

constexpr glm::dvec2 picture{200, 100};
constexpr double rounding = 1e-4; // pixels, of matrices in floats

void expect_at(glm::dvec2 at, glm::dvec2 expected) {
    EXPECT_NEAR(at.x, expected.x, rounding);
    EXPECT_NEAR(at.y, expected.y, rounding);
}

// --- pieces

TEST(VectorPieces, StandWhereTheCameraSeesThem) {
    Lines lines;
    lines.add(LineKind::crease, {{0, 0, 0}, {3, 1, -4}});
    const View view{.eye = {1, 2, 6}, .target = {1, 0, 0}, .near = 1, .far = 20};
    const Camera camera = make_camera(view, {400, 300}, {});
    Cuts cuts{lines.set, camera};
    cuts.add(0, 0, 0.4F, true);
    cuts.add(0, 0.4F, 1, false);
    const Pieces pieces = make_pieces(lines.set, camera, cuts.intervals);
    ASSERT_EQ(pieces.list.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const Interval& interval = cuts.intervals[i];
        const VectorPoint start = pieces.start(pieces.list[i]);
        EXPECT_NEAR(start.at.x, static_cast<double>(interval.start[0]), 1e-3);
        EXPECT_NEAR(start.at.y, 300 - static_cast<double>(interval.start[1]), 1e-3);
        EXPECT_NEAR(start.depth, static_cast<double>(interval.start_depth), 1e-5);
        EXPECT_NEAR(start.arc, static_cast<double>(interval.start_arc), 1e-3);
        const VectorPoint end = pieces.end(pieces.list[i]);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(end.world[axis], static_cast<double>(interval.end_world[axis]), 1e-3);
        }
    }
}

TEST(VectorPieces, LeaveOutWhatIsBehindTheEyeOrNoNumber) {
    Lines lines;
    lines.add(LineKind::crease, {{0, 0, 0}, {1, 0, 0}});
    lines.add(LineKind::crease, {{0, 0, 9}, {1, 0, 9}});
    const View view{.eye = {0, 0, 6}, .target = {0, 0, 0}, .near = 1, .far = 20};
    const Camera camera = make_camera(view, {400, 300}, {});
    Cuts cuts{lines.set, camera};
    cuts.add_all();
    cuts.intervals.push_back(cuts.intervals.front());
    cuts.intervals.back().start[0] = std::nanf("");
    cuts.intervals.push_back(cuts.intervals.front());
    cuts.intervals.back().segment = 99;
    EXPECT_EQ(make_pieces(lines.set, camera, cuts.intervals).list.size(), 1U);
}

// --- junctions

/// A horizontal line behind a vertical one at x = 100; visible up to `end`.
struct Crossing {
    explicit Crossing(float end, float depth = 0.2F) {
        lines.add(LineKind::crease, {{20, 50, 0.5F}, {180, 50, 0.9F}});
        lines.add(LineKind::silhouette, {{100, 10, depth}, {100, 90, depth}});
        Cuts cuts{lines.set, flat_camera()};
        const float share = (end - 20) / 160;
        cuts.add(0, 0, share, true);
        cuts.add(0, share, 1, false);
        cuts.add(1, 0, 1, true);
        pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    }
    Lines lines;
    Pieces pieces;
};

TEST(Junctions, AnEndMeetsTheNearerLineExactly) {
    for (const float end : {98.9F, 99.5F, 100.0F, 101.2F}) {
        Crossing scene{end};
        EXPECT_EQ(meet_junctions(scene.lines.set, picture, scene.pieces), 1U);
        const VectorPoint met = scene.pieces.end(scene.pieces.list[0]);
        EXPECT_NEAR(met.at.x, 100, rounding);
        EXPECT_NEAR(met.depth, 0.7, 1e-6); // of the line itself, not of the nearer one
        EXPECT_NEAR(met.world.z, 0.7, 1e-6);
        EXPECT_NEAR(met.arc, 0, rounding);
        EXPECT_EQ(scene.pieces.list[0].end.t, scene.pieces.list[1].start.t);
    }
}

TEST(Junctions, AnEndStaysWhereNothingNearerCrosses) {
    Crossing farther{99.5F, 0.8F};
    EXPECT_EQ(meet_junctions(farther.lines.set, picture, farther.pieces), 0U);
    Crossing away{98.5F};
    EXPECT_EQ(meet_junctions(away.lines.set, picture, away.pieces), 0U);
    EXPECT_NEAR(away.pieces.end(away.pieces.list[0]).at.x, 98.5, 1e-4);
}

TEST(Junctions, TheNearestOfSeveralWins) {
    Crossing scene{99.5F};
    scene.lines.add(LineKind::crease, {{99.2F, 10, 0.1F}, {99.2F, 90, 0.1F}});
    Cuts cuts{scene.lines.set, flat_camera()};
    cuts.add(0, 0, 79.5F / 160, true);
    cuts.add(0, 79.5F / 160, 1, false);
    cuts.add(1, 0, 1, true);
    cuts.add(2, 0, 1, true);
    scene.pieces = make_pieces(scene.lines.set, flat_camera(), cuts.intervals);
    EXPECT_EQ(meet_junctions(scene.lines.set, picture, scene.pieces), 1U);
    EXPECT_NEAR(scene.pieces.end(scene.pieces.list[0]).at.x, 99.2, 1e-4);
}

TEST(Junctions, WorldPointsFollowThePerspective) {
    Lines lines;
    lines.add(LineKind::crease, {{-2, 0, 2}, {3, 0, -9}});
    lines.add(LineKind::crease, {{0.4F, -3, 3}, {0.4F, 3, 3}});
    const View view{.eye = {0, 0, 8}, .target = {0, 0, 0}, .near = 1, .far = 30};
    const Camera camera = make_camera(view, {400, 300}, {});
    Cuts cuts{lines.set, camera};
    // Where the first crosses the second on the screen: found by halving.
    const Pieces whole = make_pieces(lines.set, camera, [&] {
        cuts.add_all();
        return cuts.intervals;
    }());
    const double x = whole.start(whole.list[1]).at.x;
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (whole.point(whole.list[0], middle).at.x < x ? low : high) = middle;
    }
    cuts.intervals.clear();
    const auto end = static_cast<float>(low + 0.8 / whole.segment_of(whole.list[0]).length);
    cuts.add(0, 0, end, true);
    cuts.add(1, 0, 1, true);
    Pieces pieces = make_pieces(lines.set, camera, cuts.intervals);
    ASSERT_EQ(meet_junctions(lines.set, glm::dvec2{400, 300}, pieces), 1U);
    const VectorPoint met = pieces.end(pieces.list[0]);
    EXPECT_NEAR(met.at.x, x, 1e-6);
    // The world point projects to where the end is, and lies on the line.
    const glm::dvec4 clip = glm::dmat4{camera.clip_from_world()} * glm::dvec4{met.world, 1};
    EXPECT_NEAR((clip.x / clip.w + 1) * 200, met.at.x, 1e-4);
    EXPECT_NEAR(1 / clip.w, met.inverse_w, 1e-6);
    EXPECT_NEAR((met.world.x + 2) / 5, (2 - met.world.z) / 11, 1e-6);
}

TEST(Junctions, PiecesNeverTurnRound) {
    // A visible piece of half a pixel between two nearer lines on its far sides.
    Lines lines;
    lines.add(LineKind::crease, {{20, 50, 0.5F}, {180, 50, 0.5F}});
    lines.add(LineKind::crease, {{100.6F, 10, 0.1F}, {100.6F, 90, 0.1F}});
    lines.add(LineKind::crease, {{99.4F, 10, 0.1F}, {99.4F, 90, 0.1F}});
    Cuts cuts{lines.set, flat_camera()};
    cuts.add(0, 0, 80.2F / 160, false);
    cuts.add(0, 80.2F / 160, 79.9F / 160 + 0.004F, true);
    cuts.add(0, 79.9F / 160 + 0.004F, 1, false);
    cuts.add(1, 0, 1, true);
    cuts.add(2, 0, 1, true);
    Pieces pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    meet_junctions(lines.set, picture, pieces);
    double t = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(pieces.list[i].start.t, t);
        EXPECT_GE(pieces.list[i].end.t, pieces.list[i].start.t);
        t = pieces.list[i].end.t;
    }
}

// --- chaining

std::vector<VectorPath> chained(const Lines& lines, const Cuts& cuts) {
    Pieces pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    drop_flickers(pieces);
    return chain_strips(lines.set, pieces, make_strips(lines.set, pieces));
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

// --- simplify

TEST(Simplify, PointsOnALineGoAndCornersStay) {
    VectorPath path = test::path_through(
        LineKind::crease, true, {{0, 0}, {10, 0.04}, {20, 0}, {30, 0}, {30, 20}, {30, 21}});
    simplify(path, 0.05);
    ASSERT_EQ(path.points.size(), 3U);
    EXPECT_EQ(path.points[1].at, (glm::dvec2{30, 0}));
    ASSERT_EQ(path.pieces.size(), 5U);
    EXPECT_EQ(path.pieces[2].point, 0U);
    EXPECT_EQ(path.pieces[2].segment, 2U);
    EXPECT_EQ(path.pieces[3].point, 1U);
    VectorPath exact = test::path_through(LineKind::crease, true, {{0, 0}, {10, 0.06}, {20, 0}});
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
    VectorPath path = test::path_through(LineKind::crease, true, points);
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
        test::path_through(LineKind::crease, true, {{5, 5}, {5.004, 5}, {5.004, 5.004}}),
        test::path_through(LineKind::crease, true, {{5, 5}, {5.02, 5}})};
    simplify(paths, 0.05);
    EXPECT_EQ(paths.size(), 1U);
}

// --- overlaps

std::vector<VectorPath> without_overlaps(const std::vector<VectorPath>& paths) {
    return remove_overlaps(paths, picture);
}

TEST(Overlaps, TheCheckerFindsWhatIsPlanted) {
    const auto overlap = [](std::vector<std::vector<glm::dvec2>> lines) {
        std::vector<VectorPath> paths;
        for (const auto& line : lines) {
            paths.push_back(test::path_through(LineKind::crease, true, line));
        }
        return test::longest_overlap(paths);
    };
    EXPECT_NEAR(overlap({{{10, 10}, {90, 10}}, {{50, 10.2}, {150, 10.2}}}), 40, 1e-6);
    EXPECT_NEAR(overlap({{{10, 10}, {90, 10}}, {{70, 10}, {60, 10}, {60, 50}}}), 10, 1e-6);
    // Of a path that folds back on itself both layers count.
    EXPECT_NEAR(overlap({{{10, 10}, {50, 10}, {30, 10}}}), 40, 1e-6);
    // Many short ones in a row are one long one.
    std::vector<glm::dvec2> fine;
    for (int i = 0; i <= 100; ++i) fine.emplace_back(20 + 0.3 * i, 10.1);
    EXPECT_NEAR(overlap({{{10, 10}, {90, 10}}, fine}), 30, 1e-6);
    EXPECT_EQ(overlap({{{10, 10}, {90, 10}}, {{10, 10.3}, {90, 10.3}}}), 0);
    EXPECT_EQ(overlap({{{10, 10}, {90, 10}}, {{90, 10}, {150, 10}}}), 0);
    EXPECT_EQ(overlap({{{10, 10}, {90, 90}}, {{10, 90}, {90, 10}}}), 0);
}

TEST(Overlaps, OfTwoEqualLinesTheOneThatMattersMoreStays) {
    const std::vector<glm::dvec2> line{{10, 10}, {90, 10}};
    const auto kept = [&](VectorPath a, VectorPath b) {
        const std::vector<VectorPath> paths = without_overlaps({std::move(a), std::move(b)});
        EXPECT_EQ(paths.size(), 1U);
        return paths.at(0);
    };
    const auto path = [&](LineKind kind, bool visible, double depth = 0.5) {
        return test::path_through(kind, visible, line, depth);
    };
    EXPECT_TRUE(kept(path(LineKind::file, false), path(LineKind::silhouette, true)).visible);
    const std::vector<LineKind> order{LineKind::file, LineKind::boundary, LineKind::material,
                                      LineKind::crease, LineKind::silhouette};
    for (std::size_t i = 1; i < order.size(); ++i) {
        EXPECT_EQ(kept(path(order[i], true, 0.1), path(order[i - 1], true)).kind, order[i - 1]);
    }
    EXPECT_EQ(
        kept(path(LineKind::crease, true, 0.6), path(LineKind::crease, true, 0.4)).points[0].depth,
        0.4);
}

TEST(Overlaps, OnlyTheCommonPartGoes) {
    const std::vector<VectorPath> paths = without_overlaps(
        {test::path_through(LineKind::file, true, {{30, 10}, {60, 10}}),
         test::path_through(LineKind::crease, true, {{10, 10.1}, {90, 10.1}, {90, 60}})});
    ASSERT_EQ(paths.size(), 3U);
    EXPECT_NEAR(length_of(paths[0]), 30, 1e-9);
    EXPECT_NEAR(length_of(paths[1]), 20, 1e-9);
    EXPECT_NEAR(length_of(paths[2]), 30 + 49.9, 1e-9);
    EXPECT_EQ(paths[2].points.size(), 3U);
    EXPECT_NEAR(paths[2].points[0].arc, 50, 1e-9);
    EXPECT_EQ(paths[2].pieces.front().segment, 0U);
    EXPECT_EQ(paths[2].pieces.back().segment, 1U);
}

TEST(Overlaps, APathThatFoldsBackIsDrawnOnce) {
    const std::vector<VectorPath> paths = without_overlaps(
        {test::path_through(LineKind::crease, true, {{10, 10}, {90, 10}, {40, 10.1}, {40, 60}})});
    EXPECT_LE(test::longest_overlap(paths), 0.5);
    EXPECT_NEAR(test::total_length(paths), 80 + 50, 0.3);
}

TEST(Overlaps, ALoopThatIsCutStaysWholeAcrossItsStart) {
    const std::vector<VectorPath> paths =
        without_overlaps({test::path_through(LineKind::file, true, {{90, 20}, {90, 40}}),
                          test::path_through(LineKind::crease, true,
                                             {{10, 10}, {90, 10}, {90, 60}, {10, 60}, {10, 10}})});
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_FALSE(paths[1].closed);
    EXPECT_NEAR(length_of(paths[1]), 260 - 20, 1e-9);
}

TEST(Overlaps, WhatOnlyMeetsOrCrossesStays) {
    const std::vector<VectorPath> paths{
        test::path_through(LineKind::crease, true, {{10, 10}, {90, 10}}),
        test::path_through(LineKind::crease, true, {{90, 10}, {150, 10}}), // goes on
        test::path_through(LineKind::crease, true, {{90, 10}, {150, 40}}), // forks
        test::path_through(LineKind::crease, true, {{50, 0}, {52, 90}}),
        test::path_through(LineKind::crease, true, {{10, 10.4}, {90, 10.4}})};
    EXPECT_NEAR(test::total_length(without_overlaps(paths)), test::total_length(paths), 1e-9);
}

/// Paths of short lines, many of them along others: exact copies, shifted ones, ones walked the
/// other way, and others cut differently.
std::vector<VectorPath> crowd(std::size_t pieces, glm::dvec2 size) {
    test::Random random{5};
    std::vector<VectorPath> paths;
    std::size_t made = 0;
    while (made < pieces) {
        std::vector<glm::dvec2> points{{random.between(0, static_cast<float>(size.x)),
                                        random.between(0, static_cast<float>(size.y))}};
        double angle = static_cast<double>(random.between(0, 6));
        for (int i = 0; i < 25; ++i) {
            angle += static_cast<double>(random.between(-0.2F, 0.2F));
            points.push_back(points.back() + glm::dvec2{std::cos(angle), std::sin(angle)} *
                                                 static_cast<double>(random.between(0.3F, 6)));
        }
        const auto kind = static_cast<LineKind>(random.below(5));
        paths.push_back(test::path_through(kind, random.coin(), points));
        if (random.coin()) {
            const glm::dvec2 shift{random.between(-0.15F, 0.15F), random.between(-0.15F, 0.15F)};
            std::vector<glm::dvec2> copy;
            for (std::size_t i = 3; i < points.size(); ++i) {
                copy.push_back(points[i] + shift);
                if (i + 1 < points.size() && random.coin()) {
                    copy.push_back(0.3 * points[i] + 0.7 * points[i + 1] + shift);
                }
            }
            if (random.coin()) std::ranges::reverse(copy);
            paths.push_back(test::path_through(kind, random.coin(), copy));
        }
        made = 0;
        for (const VectorPath& path : paths) made += path.points.size() - 1;
    }
    return paths;
}

TEST(Overlaps, NoneOfACrowdIsLeft) {
    const std::vector<VectorPath> paths = crowd(4000, {300, 300});
    ASSERT_GT(test::longest_overlap(paths), 20);
    const std::vector<VectorPath> clean = remove_overlaps(paths, {300, 300});
    EXPECT_LE(test::longest_overlap(clean), 0.5);
    EXPECT_GT(test::total_length(clean), 0.5 * test::total_length(paths));
}

TEST(Overlaps, AHundredThousandPiecesTakeLessThanASecond) {
    std::vector<VectorPath> paths;
    { // the crowd is made anew every round, so a small one is repeated beside itself
        const std::vector<VectorPath> one = crowd(1000, {200, 200});
        for (int i = 0; i < 100; ++i) {
            const glm::dvec2 shift{i % 10 * 190, i / 10 * 105};
            for (VectorPath path : one) {
                for (VectorPoint& point : path.points) point.at += shift;
                paths.push_back(std::move(path));
            }
        }
    }
    const auto start = std::chrono::steady_clock::now();
    const std::vector<VectorPath> clean = remove_overlaps(paths, {1920, 1080});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    RecordProperty("milliseconds", static_cast<int>(1000 * taken.count()));
    EXPECT_LT(taken.count(), 1);
    EXPECT_LE(test::longest_overlap(clean), 0.5);
}

// --- all of it

/// A scene's lines with made-up visibility: every segment cut at random places.
VectorDrawing scene_drawing(const char* name, bool hidden, const VectorOptions& options = {}) {
    const Scene scene = make_scene(name);
    const LineSet lines = extract_lines(scene.mesh);
    const Camera camera = make_camera(scene.view(0.3F), {1200, 900}, lines.bounds);
    test::Random random{3};
    Cuts cuts{lines, camera};
    for (std::uint32_t i = 0; i < lines.segments.size(); ++i) {
        const bool candidate = (lines.segments[i].tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
        if (candidate && random.below(8) != 0) continue; // most are no silhouette
        bool visible = random.coin();
        float from = 0;
        while (from < 1) {
            const float to = random.coin() ? 1 : random.between(from, 1.2F);
            cuts.add(i, from, std::min(to, 1.0F), visible);
            visible = !visible;
            from = to;
        }
    }
    Style style{};
    style.hidden = hidden;
    VectorOptions with_mesh = options;
    with_mesh.mesh = &scene.mesh;
    return make_vector_drawing(lines, camera, cuts.intervals, style, with_mesh);
}

TEST(VectorDrawings, OfScenesAreSound) {
    for (const char* name : {"clevis", "house"}) {
        for (const bool hidden : {false, true}) {
            const VectorDrawing drawing = scene_drawing(name, hidden);
            EXPECT_GT(drawing.paths.size(), 50U);
            EXPECT_EQ(test::flaws_of(drawing), "");
            EXPECT_LE(test::longest_overlap(drawing.paths), 0.5) << name << ' ' << hidden;
            EXPECT_EQ(std::ranges::any_of(drawing.paths,
                                          [](const VectorPath& path) { return !path.visible; }),
                      hidden);
        }
    }
}

TEST(VectorDrawings, ForAPlotterAreSoundToo) {
    const VectorDrawing plain = scene_drawing("house", false);
    const VectorDrawing drawing = scene_drawing("house", false, {.plotter = true});
    EXPECT_EQ(test::flaws_of(drawing), "");
    EXPECT_LE(test::longest_overlap(drawing.paths), 0.5);
    ASSERT_TRUE(drawing.travel);
    EXPECT_LT(drawing.travel->after, 0.1 * drawing.travel->before);
    EXPECT_NEAR(test::total_length(drawing.paths), test::total_length(plain.paths),
                0.1 * static_cast<double>(plain.paths.size()));
}

TEST(VectorDrawings, HiddenLinesComeFirst) {
    const VectorDrawing drawing = scene_drawing("clevis", true);
    EXPECT_TRUE(std::ranges::is_sorted(drawing.paths, {}, &VectorPath::visible));
}

TEST(VectorDrawings, OfNothingAreEmpty) {
    const VectorDrawing drawing = make_vector_drawing({}, flat_camera(), {}, {});
    EXPECT_TRUE(drawing.paths.empty());
}

} // namespace
} // namespace lineatlas
