#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "vector/junctions.hpp"
#include "vector/pieces.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using test::Cuts;
using test::flat_camera;
using test::Lines;

constexpr double rounding = 1e-4; // pixels, of matrices in floats

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

/// A horizontal line behind a vertical one at x = 100. It is visible up to `end`.
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
        EXPECT_EQ(meet_junctions(scene.lines.set, flat_camera(), scene.pieces), 1U);
        const VectorPoint met = scene.pieces.end(scene.pieces.list[0]);
        EXPECT_NEAR(met.at.x, 100, rounding);
        EXPECT_NEAR(met.depth, 0.7, 1e-6); // the depth of the line itself, not of the nearer one
        EXPECT_NEAR(met.world.z, 0.7, 1e-6);
        EXPECT_NEAR(met.arc, 0, rounding);
        EXPECT_EQ(scene.pieces.list[0].end.t, scene.pieces.list[1].start.t);
    }
}

TEST(Junctions, AnEndStaysWhereNothingNearerCrosses) {
    Crossing farther{99.5F, 0.8F};
    EXPECT_EQ(meet_junctions(farther.lines.set, flat_camera(), farther.pieces), 0U);
    Crossing away{98.5F};
    EXPECT_EQ(meet_junctions(away.lines.set, flat_camera(), away.pieces), 0U);
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
    EXPECT_EQ(meet_junctions(scene.lines.set, flat_camera(), scene.pieces), 1U);
    EXPECT_NEAR(scene.pieces.end(scene.pieces.list[0]).at.x, 99.2, 1e-4);
}

TEST(Junctions, WorldPointsFollowThePerspective) {
    Lines lines;
    lines.add(LineKind::crease, {{-2, 0, 2}, {3, 0, -9}});
    lines.add(LineKind::crease, {{0.4F, -3, 3}, {0.4F, 3, 3}});
    const View view{.eye = {0, 0, 8}, .target = {0, 0, 0}, .near = 1, .far = 30};
    const Camera camera = make_camera(view, {400, 300}, {});
    Cuts cuts{lines.set, camera};
    // The place where the first line crosses the second on the screen is found by halving.
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
    ASSERT_EQ(meet_junctions(lines.set, camera, pieces), 1U);
    const VectorPoint met = pieces.end(pieces.list[0]);
    EXPECT_NEAR(met.at.x, x, 1e-6);
    // The point in the world projects to the end and lies on the line.
    const glm::dvec4 clip = glm::dmat4{camera.clip_from_world()} * glm::dvec4{met.world, 1};
    EXPECT_NEAR((clip.x / clip.w + 1) * 200, met.at.x, 1e-4);
    EXPECT_NEAR(1 / clip.w, met.inverse_w, 1e-6);
    EXPECT_NEAR((met.world.x + 2) / 5, (2 - met.world.z) / 11, 1e-6);
}

/// A level line whose visibility changes 1 pixel before its right end, where another line begins.
struct Corner {
    explicit Corner(bool visible_at_vertex, bool corner = true) {
        lines.add(LineKind::crease, {{20, 50, 0.5F}, {120, 50, 0.5F}});
        lines.add(LineKind::silhouette, {{120, corner ? 50.0F : 53.0F, 0.5F}, {130, 90, 0.5F}});
        Cuts cuts{lines.set, flat_camera()};
        cuts.add(0, 0, 0.99F, !visible_at_vertex);
        cuts.add(0, 0.99F, 1, visible_at_vertex);
        cuts.add(1, 0, 1, true);
        pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    }
    Lines lines;
    Pieces pieces;
};

TEST(Junctions, AnEndMeetsAVertexOfAnotherLine) {
    Corner shown{false};
    EXPECT_EQ(meet_junctions(shown.lines.set, flat_camera(), shown.pieces), 1U);
    EXPECT_EQ(shown.pieces.list[0].end.t, 1);
    EXPECT_EQ(shown.pieces.list[0].end.kind, LA_END_PATH);
    EXPECT_EQ(shown.pieces.length(shown.pieces.list[1]), 0);
    Corner hidden{true};
    EXPECT_EQ(meet_junctions(hidden.lines.set, flat_camera(), hidden.pieces), 1U);
    EXPECT_EQ(hidden.pieces.length(hidden.pieces.list[1]), 0);
    EXPECT_EQ(hidden.pieces.list[0].end.t, 1);
    Corner alone{false, false};
    EXPECT_EQ(meet_junctions(alone.lines.set, flat_camera(), alone.pieces), 0U);
}

// As where a plate's rounded edge is seen end on.
TEST(Junctions, AChordSeenEndOnMeetsNothing) {
    Lines lines;
    lines.add(LineKind::silhouette, {{20, 50, 0.5F}, {60, 50, 0.5F}, {60, 50, 0.6F}});
    lines.set.contours.corners.resize(3);
    for (std::uint32_t i = 0; i < 3; ++i) lines.set.contours.corners[i].vertex = i;
    lines.set.contours.edges = {{0, 1}, {1, 2}, {2, 0}};
    lines.set.contours.faces.assign(2, {0, 1, 2});
    lines.set.contours.surfaces.of_triangle = {0, 0};
    Cuts cuts{lines.set, flat_camera()};
    cuts.add(0, 0, 1, true);
    cuts.add(1, 0, 1, false);
    for (Interval& interval : cuts.intervals) interval.flags |= LA_INTERVAL_EXACT;
    Pieces pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    ASSERT_TRUE(pieces.exact);
    EXPECT_EQ(meet_junctions(lines.set, flat_camera(), pieces), 0U);
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
    meet_junctions(lines.set, flat_camera(), pieces);
    double t = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(pieces.list[i].start.t, t);
        EXPECT_GE(pieces.list[i].end.t, pieces.list[i].start.t);
        t = pieces.list[i].end.t;
    }
}

} // namespace
} // namespace lineatlas
