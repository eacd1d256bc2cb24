#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "test_meshes.hpp"
#include "vector/end_grid.hpp"
#include "vector/paths.hpp"
#include "vector/plotter.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

std::vector<VectorPath> strokes(std::size_t count, glm::dvec2 size) {
    test::Random random{8};
    std::vector<VectorPath> paths;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 at{random.between(0, static_cast<float>(size.x)),
                            random.between(0, static_cast<float>(size.y))};
        const double angle = static_cast<double>(random.between(0, 6.28F));
        const double length = static_cast<double>(random.between(2, 30));
        paths.push_back(
            path_through(LineKind::crease, true,
                         {at, at + length * glm::dvec2{std::cos(angle), std::sin(angle)}}));
    }
    return paths;
}

double travel_of(const std::vector<VectorPath>& paths) {
    double travel = 0;
    for (std::size_t i = 1; i < paths.size(); ++i) {
        travel += glm::distance(paths[i - 1].points.back().at, paths[i].points.front().at);
    }
    return travel;
}

TEST(EndGrid, FindsTheNearest) {
    test::Random random{4};
    std::vector<PathEnd> ends;
    for (std::uint32_t i = 0; i < 500; ++i) {
        ends.push_back({{random.between(-20, 300), random.between(0, 40)}, i / 2, i % 2});
    }
    EndGrid grid{ends, 250};
    glm::dvec2 at{500, -90}; // the first search starts outside
    std::vector<bool> taken(250, false);
    for (int round = 0; round < 250; ++round) {
        double nearest = 1e9;
        for (const PathEnd& end : ends) {
            if (!taken[end.path]) nearest = std::min(nearest, glm::distance(end.at, at));
        }
        const std::optional<PathEnd> found = grid.nearest(at);
        ASSERT_TRUE(found);
        EXPECT_EQ(glm::distance(found->at, at), nearest);
        taken[found->path] = true;
        grid.take(found->path);
        at = {random.between(-50, 350), random.between(-20, 60)};
    }
    EXPECT_FALSE(grid.nearest(at));
}

TEST(Plotter, TravelsAFractionOfTheWay) {
    std::vector<VectorPath> paths = strokes(2000, {1000, 800});
    const double before = travel_of(paths);
    const double length = test::total_length(paths);
    const PenTravel travel = order_for_plotter(paths);
    EXPECT_NEAR(travel.before, before, 1e-6);
    EXPECT_NEAR(travel.after, travel_of(paths), 1e-6);
    // The length of the best tour through many random points is 0.7124 sqrt(n area).
    EXPECT_LT(travel.after, 0.7124 * std::sqrt(2000 * 1000.0 * 800));
    EXPECT_NEAR(test::total_length(paths), length, 1);
}

TEST(Plotter, JoinsEndsThatMeet) {
    std::vector<VectorPath> paths{
        path_through(LineKind::crease, true, {{0, 0}, {10, 0}}),
        path_through(LineKind::crease, true, {{20, 0.05}, {30, 0}}),
        path_through(LineKind::crease, true, {{20, 0}, {10, 0.05}}),
        path_through(LineKind::crease, true, {{30.2, 0}, {40, 0}}),
        path_through(LineKind::file, true, {{40, 0}, {50, 0}}),
    };
    const PenTravel travel = order_for_plotter(paths);
    EXPECT_EQ(travel.paths_before, 5U);
    ASSERT_EQ(paths.size(), 3U);
    EXPECT_EQ(travel.paths_after, 3U);
    EXPECT_EQ(paths[0].points.size(), 6U);
    EXPECT_NEAR(length_of(paths[0]), 30.1, 0.01);
    EXPECT_EQ(paths[0].pieces.back().point, 4U);
    EXPECT_NEAR(travel.after, 0.2, 1e-9);
}

TEST(Plotter, ClosesPathsThatReturnToTheirStart) {
    std::vector<VectorPath> paths{
        path_through(LineKind::boundary, true, {{0, 0}, {10, 0}, {10, 10}}),
        path_through(LineKind::boundary, true, {{0, 0.05}, {0, 10}, {10, 10}}),
        path_through(LineKind::file, true, {{20, 0}, {30, 0}, {30, 10}, {20, 0.5}}),
        path_through(LineKind::section, true, {{40, 0}, {40.05, 0}, {40.05, 0.05}, {40, 0}}),
    };
    order_for_plotter(paths);
    ASSERT_EQ(paths.size(), 3U);
    EXPECT_TRUE(paths[0].closed);
    EXPECT_EQ(paths[0].points.front().at, paths[0].points.back().at);
    EXPECT_NEAR(length_of(paths[0]), 40, 0.06);
    EXPECT_EQ(paths[0].pieces.back().point + 2, paths[0].points.size());
    EXPECT_FALSE(paths[1].closed) << "it ends half a pixel away";
}

TEST(Plotter, LoopsStartWhereThePenIs) {
    std::vector<VectorPath> paths{
        path_through(LineKind::crease, true, {{0, 0}, {50, 50}}),
        path_through(LineKind::crease, true, {{90, 90}, {90, 51}, {51, 51}, {51, 90}, {90, 90}}),
    };
    const PenTravel travel = order_for_plotter(paths);
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_TRUE(paths[1].closed);
    EXPECT_EQ(paths[1].points.front().at, (glm::dvec2{51, 51}));
    EXPECT_EQ(paths[1].points.back().at, (glm::dvec2{51, 51}));
    EXPECT_NEAR(travel.after, std::numbers::sqrt2, 1e-9);
    std::vector<std::uint32_t> points;
    for (const VectorPiece& piece : paths[1].pieces) points.push_back(piece.point);
    EXPECT_EQ(points, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(paths[1].pieces[0].segment, 2U); // from (51, 51) on
}

TEST(Plotter, GroupsStayTogether) {
    std::vector<VectorPath> paths;
    for (int i = 0; i < 40; ++i) {
        paths.push_back(path_through(i < 20 ? LineKind::crease : LineKind::file,
                                     i % 20 < 10 ? false : true,
                                     {{i * 7 % 40, 0}, {i * 7 % 40, 5}}));
    }
    std::ranges::stable_sort(paths, {}, [](const VectorPath& p) {
        return std::pair{p.visible, p.kind};
    });
    order_for_plotter(paths);
    EXPECT_TRUE(std::ranges::is_sorted(paths, {}, [](const VectorPath& p) {
        return std::pair{p.visible, p.kind};
    }));
}

TEST(Plotter, ManyPathsTravelLittle) {
    std::vector<VectorPath> paths = strokes(25000, {4000, 3000});
    const PenTravel travel = order_for_plotter(paths);
    EXPECT_LT(travel.after, 0.7124 * std::sqrt(25000 * 4000.0 * 3000)); // as above
}

TEST(Paths, ReversedTwiceAreTheSame) {
    const VectorPath path =
        path_through(LineKind::crease, true, {{0, 0}, {10, 0}, {10, 9}, {0, 9}});
    VectorPath turned = path;
    reverse(turned);
    EXPECT_EQ(turned.points.front().at, path.points.back().at);
    EXPECT_EQ(turned.pieces.front().segment, 2U);
    EXPECT_EQ(turned.pieces.front().point, 0U);
    reverse(turned);
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
        EXPECT_EQ(turned.pieces[i].point, path.pieces[i].point);
        EXPECT_EQ(turned.pieces[i].segment, path.pieces[i].segment);
    }
}

} // namespace
} // namespace lineatlas
