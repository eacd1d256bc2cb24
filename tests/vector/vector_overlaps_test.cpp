#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "test_meshes.hpp"
#include "vector/overlaps.hpp"
#include "vector/paths.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

constexpr glm::dvec2 picture{200, 100};

std::vector<VectorPath> without_overlaps(const std::vector<VectorPath>& paths) {
    return remove_overlaps(paths, picture);
}

TEST(Overlaps, TheCheckerFindsWhatIsPlanted) {
    const auto overlap = [](std::vector<std::vector<glm::dvec2>> lines) {
        std::vector<VectorPath> paths;
        for (const auto& line : lines) {
            paths.push_back(path_through(LineKind::crease, true, line));
        }
        return test::longest_overlap(paths);
    };
    EXPECT_NEAR(overlap({{{10, 10}, {90, 10}}, {{50, 10.2}, {150, 10.2}}}), 40, 1e-6);
    EXPECT_NEAR(overlap({{{10, 10}, {90, 10}}, {{70, 10}, {60, 10}, {60, 50}}}), 10, 1e-6);
    // Both layers of a path that folds back on itself count.
    EXPECT_NEAR(overlap({{{10, 10}, {50, 10}, {30, 10}}}), 40, 1e-6);
    // Many short overlaps in a row are one long overlap.
    std::vector<glm::dvec2> fine;
    for (int i = 0; i <= 100; ++i) fine.emplace_back(20 + 0.3 * i, 10.1);
    EXPECT_NEAR(overlap({{{10, 10}, {90, 10}}, fine}), 30, 1e-6);
    EXPECT_EQ(overlap({{{10, 10}, {90, 10}}, {{10, 10.3}, {90, 10.3}}}), 0);
    EXPECT_EQ(overlap({{{10, 10}, {90, 10}}, {{90, 10}, {150, 10}}}), 0);
    EXPECT_EQ(overlap({{{10, 10}, {90, 90}}, {{10, 90}, {90, 10}}}), 0);
}

TEST(Overlaps, WhatIsLeftOutCoversNothing) {
    // Each line runs along the one before, except for 0.3 pixels at its end, which are too short to
    // be drawn. If these removed parts of the next line, no other line would be drawn.
    std::vector<VectorPath> paths;
    for (int i = 0; i < 200; ++i) {
        const double from = 10 + 0.3 * i;
        paths.push_back(
            path_through(LineKind::crease, true, {{from, 50}, {from + 20, 50}}, 0.001 * i));
    }
    double length = 0;
    for (const VectorPath& path : without_overlaps(paths))
        length += glm::distance(path.points.front().at, path.points.back().at);
    EXPECT_NEAR(length, 20 + 0.3 * 199, 0.5);
}

TEST(Overlaps, OfTwoEqualLinesTheOneThatMattersMoreStays) {
    const std::vector<glm::dvec2> line{{10, 10}, {90, 10}};
    const auto kept = [&](VectorPath a, VectorPath b) {
        const std::vector<VectorPath> paths = without_overlaps({std::move(a), std::move(b)});
        EXPECT_EQ(paths.size(), 1U);
        return paths.at(0);
    };
    const auto path = [&](LineKind kind, bool visible, double depth = 0.5) {
        return path_through(kind, visible, line, depth);
    };
    EXPECT_TRUE(kept(path(LineKind::file, false), path(LineKind::silhouette, true)).visible);
    const std::vector<LineKind> order{LineKind::file,     LineKind::boundary,   LineKind::crease,
                                      LineKind::material, LineKind::silhouette, LineKind::tangent,
                                      LineKind::trail,    LineKind::centre};
    for (std::size_t i = 1; i < order.size(); ++i) {
        EXPECT_EQ(kept(path(order[i], true, 0.1), path(order[i - 1], true)).kind, order[i - 1]);
    }
    EXPECT_FALSE(kept(path(LineKind::centre, true), path(LineKind::crease, false)).visible)
        << "ISO 128-2: edges, hidden edges, centre lines";
    EXPECT_EQ(
        kept(path(LineKind::crease, true, 0.6), path(LineKind::crease, true, 0.4)).points[0].depth,
        0.4);
}

TEST(Overlaps, OnlyTheCommonPartGoes) {
    const std::vector<VectorPath> paths = without_overlaps(
        {path_through(LineKind::file, true, {{30, 10}, {60, 10}}),
         path_through(LineKind::crease, true, {{10, 10.1}, {90, 10.1}, {90, 60}})});
    ASSERT_EQ(paths.size(), 3U);
    EXPECT_NEAR(length_of(paths[0]), 30, 1e-9);
    EXPECT_NEAR(length_of(paths[1]), 20, 1e-9);
    EXPECT_NEAR(length_of(paths[2]), 30 + 49.9, 1e-9);
    EXPECT_EQ(paths[2].points.size(), 3U);
    EXPECT_NEAR(paths[2].points[0].arc, 50, 1e-9);
    EXPECT_EQ(paths[2].pieces.front().segment, 0U);
    EXPECT_EQ(paths[2].pieces.back().segment, 1U);
}

TEST(Overlaps, AnEdgeMayRunAlongAnotherOnlyToItsEnd) {
    for (const bool at_end : {false, true}) {
        VectorPath edge = path_through(LineKind::crease, true, {{20, 80}, {30, 10}, {50, 10}});
        for (VectorPiece& piece : edge.pieces) piece.edge = 1;
        std::vector<glm::dvec2> line{{10, 10}, {50, 10}};
        if (!at_end) line.emplace_back(90, 10);
        const std::vector<VectorPath> paths =
            without_overlaps({path_through(LineKind::file, true, line), edge});
        EXPECT_NEAR(test::longest_overlap(paths), at_end ? 20 : 0, 0.5);
    }
}

TEST(Overlaps, APathThatFoldsBackIsDrawnOnce) {
    const std::vector<VectorPath> paths = without_overlaps(
        {path_through(LineKind::crease, true, {{10, 10}, {90, 10}, {40, 10.1}, {40, 60}})});
    EXPECT_LE(test::longest_overlap(paths), 0.5);
    EXPECT_NEAR(test::total_length(paths), 80 + 50, 0.3);
}

TEST(Overlaps, ALoopThatIsCutStaysWholeAcrossItsStart) {
    const std::vector<VectorPath> paths = without_overlaps(
        {path_through(LineKind::file, true, {{90, 20}, {90, 40}}),
         path_through(LineKind::crease, true, {{10, 10}, {90, 10}, {90, 60}, {10, 60}, {10, 10}})});
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_FALSE(paths[1].closed);
    EXPECT_NEAR(length_of(paths[1]), 260 - 20, 1e-9);
}

TEST(Overlaps, WhatOnlyMeetsOrCrossesStays) {
    const std::vector<VectorPath> paths{
        path_through(LineKind::crease, true, {{10, 10}, {90, 10}}),
        path_through(LineKind::crease, true, {{90, 10}, {150, 10}}), // goes on
        path_through(LineKind::crease, true, {{90, 10}, {150, 40}}), // forks
        path_through(LineKind::crease, true, {{50, 0}, {52, 90}}),
        path_through(LineKind::crease, true, {{10, 10.4}, {90, 10.4}})};
    EXPECT_NEAR(test::total_length(without_overlaps(paths)), test::total_length(paths), 1e-9);
}

/// Paths of short lines, many of which run along others: exact copies, shifted copies, reversed
/// ones, and copies that are cut differently.
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
        paths.push_back(path_through(kind, random.coin(), points));
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
            paths.push_back(path_through(kind, random.coin(), copy));
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

TEST(Overlaps, NoneOfAHundredThousandPiecesIsLeft) {
    std::vector<VectorPath> paths;
    { // a small crowd is repeated beside itself, because a crowd is made again every round
        const std::vector<VectorPath> one = crowd(1000, {200, 200});
        for (int i = 0; i < 100; ++i) {
            const glm::dvec2 shift{i % 10 * 190, i / 10 * 105};
            for (VectorPath path : one) {
                for (VectorPoint& point : path.points) point.at += shift;
                paths.push_back(std::move(path));
            }
        }
    }
    EXPECT_LE(test::longest_overlap(remove_overlaps(paths, {1920, 1080})), 0.5);
}

} // namespace
} // namespace lineatlas
