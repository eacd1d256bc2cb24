// The plane divided by lines: where they meet, which faces there are, and what is joined of them.
#include <map>
#include <numeric>
#include <random>
#include <set>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "fills/areas.hpp"
#include "fills/face_points.hpp"
#include "fills/planar_map.hpp"

namespace lineatlas {
namespace {

constexpr glm::ivec2 size{64, 64};
const GridScale scale{size};

GridLine line(glm::dvec2 a, glm::dvec2 b) {
    return {scale.place(a), scale.place(b)};
}

void add_square(std::vector<GridLine>& lines, glm::dvec2 low, double side) {
    const glm::dvec2 high = low + side;
    lines.push_back(line(low, {high.x, low.y}));
    lines.push_back(line({high.x, low.y}, high));
    lines.push_back(line(high, {low.x, high.y}));
    lines.push_back(line({low.x, high.y}, low));
}

PlanarMap map_of(const std::vector<GridLine>& lines) {
    SnappedEdges edges = snap_lines(lines, size, scale);
    drop_free_ends(edges);
    return {std::move(edges), size, scale};
}

/// In pixels.
double area_of(const Area& area) {
    double twice = 0;
    for (const std::vector<GridPlace>& ring : area.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a = scale.pixels(ring[i]);
            const glm::dvec2 b = scale.pixels(ring[(i + 1) % ring.size()]);
            twice += a.x * b.y - a.y * b.x;
        }
    }
    return twice / 2;
}

/// Each face an area of its own.
std::vector<Area> areas_of_faces(const PlanarMap& map) {
    std::vector<std::uint32_t> kinds(map.face_count());
    std::iota(kinds.begin(), kinds.end(), 0U);
    return join_faces(map, kinds, 0);
}

std::multiset<double> sizes_of_faces(const PlanarMap& map) {
    std::multiset<double> sizes;
    for (const Area& area : areas_of_faces(map)) sizes.insert(area_of(area));
    return sizes;
}

TEST(PlanarMap, ACrossDividesASquareInFour) {
    std::vector<GridLine> lines;
    add_square(lines, {10, 10}, 40);
    lines.push_back(line({30, 8}, {30, 52})); // over the border: what is beyond ends freely
    lines.push_back(line({8, 20}, {52, 20}));
    EXPECT_EQ(sizes_of_faces(map_of(lines)), (std::multiset<double>{200, 200, 600, 600}));
}

TEST(PlanarMap, SquaresInOneAnotherAreRings) {
    std::vector<GridLine> lines;
    for (const double inset : {4.0, 12.0, 20.0, 28.0})
        add_square(lines, glm::dvec2{inset}, 64 - 2 * inset);
    add_square(lines, {5, 5}, 2); // two beside each other in the outer ring
    add_square(lines, {8, 5}, 2);
    EXPECT_EQ(
        sizes_of_faces(map_of(lines)),
        (std::multiset<double>{4, 4, 64, 24 * 24 - 64, 40 * 40 - 24 * 24, 56 * 56 - 40 * 40 - 8}));
}

TEST(PlanarMap, PointsLieInTheirFaces) {
    std::vector<GridLine> lines;
    for (const double inset : {4.0, 12.0, 20.0})
        add_square(lines, glm::dvec2{inset}, 64 - 2 * inset);
    const PlanarMap map = map_of(lines);
    std::map<std::uint32_t, std::pair<double, double>> range; // of twice the way from the middle
    for (const Area& area : areas_of_faces(map)) {
        const double own = area_of(area);
        range[area.kind] = own > 1500  ? std::pair{40.0, 56.0}
                           : own > 900 ? std::pair{24.0, 40.0}
                                       : std::pair{0.0, 24.0};
    }
    std::set<std::uint32_t> seen;
    for (const FacePoint& point : face_points(map, scale.per_pixel, std::vector<bool>(3, true))) {
        const glm::dvec2 from_middle = glm::abs(point.at / scale.per_pixel - 32.0);
        const double away = 2 * std::max(from_middle.x, from_middle.y);
        EXPECT_LT(away, range[point.face].second);
        EXPECT_GE(away, range[point.face].first);
        seen.insert(point.face);
    }
    EXPECT_EQ(seen.size(), 3U);
}

TEST(PlanarMap, AnyLinesDivideTheSquareWithoutRest) {
    std::mt19937 random{7};
    const auto coordinate = [&] { return static_cast<double>(random() % 60001) / 1000 + 2; };
    for (int round = 0; round < 20; ++round) {
        std::vector<GridLine> lines;
        add_square(lines, {1, 1}, 62);
        for (int i = 0; i < 60; ++i) {
            const double x = coordinate(), y = coordinate();
            lines.push_back(line({x, y}, {coordinate(), coordinate()}));
        }
        const PlanarMap map = map_of(lines);
        std::set<std::uint32_t> used;
        for (std::uint32_t h = 0; h < map.half_edge_count(); ++h) used.insert(map.start_of(h));
        // Euler, of the square and of the lines within it; the face around is not counted.
        EXPECT_EQ(map.face_count(), map.half_edge_count() / 2 - used.size() + 2);
        double sum = 0;
        for (const Area& area : areas_of_faces(map)) {
            EXPECT_GT(area_of(area), 0);
            sum += area_of(area);
        }
        EXPECT_NEAR(sum, 62 * 62, 1e-9);
    }
}

TEST(PlanarMap, WhatIsOfOneKindIsJoined) {
    std::vector<GridLine> lines;
    add_square(lines, {10, 10}, 40);
    lines.push_back(line({30, 10}, {30, 50}));
    lines.push_back(line({10, 30}, {50, 30}));
    const PlanarMap map = map_of(lines);
    const std::vector<std::uint32_t> kinds(map.face_count(), 3);
    const std::vector<Area> areas = join_faces(map, kinds, 1);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_EQ(areas[0].kind, 3U);
    ASSERT_EQ(areas[0].rings.size(), 1U);
    EXPECT_EQ(areas[0].rings[0].size(), 4U); // no place where the lines met the border
    EXPECT_EQ(area_of(areas[0]), 1600);
}

} // namespace
} // namespace lineatlas
