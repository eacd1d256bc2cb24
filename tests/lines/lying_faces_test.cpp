#include "lines/lying_faces.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "lineatlas/lines.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

/// A sheet of squares along x and y, bent upwards by a right angle about the line at x = fold.
Mesh folded_sheet(std::uint32_t squares, std::uint32_t fold) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= squares; ++y) {
        for (std::uint32_t x = 0; x <= squares; ++x) {
            const std::uint32_t flat = std::min(x, fold);
            mesh.positions.emplace_back(static_cast<float>(flat), static_cast<float>(y),
                                        static_cast<float>(x - flat));
        }
    }
    for (std::uint32_t y = 0; y < squares; ++y) {
        for (std::uint32_t x = 0; x < squares; ++x) {
            const std::uint32_t i = y * (squares + 1) + x, above = i + squares + 1;
            mesh.triangles.insert(mesh.triangles.end(),
                                  {{i, i + 1, above}, {i + 1, above + 1, above}});
        }
    }
    return mesh;
}

/// The other side of it, cut along the other diagonals.
Mesh with_other_side(Mesh mesh, std::uint32_t squares) {
    for (std::uint32_t y = 0; y < squares; ++y) {
        for (std::uint32_t x = 0; x < squares; ++x) {
            const std::uint32_t i = y * (squares + 1) + x, above = i + squares + 1;
            mesh.triangles.insert(mesh.triangles.end(),
                                  {{i, above, above + 1}, {i, above + 1, i + 1}});
        }
    }
    return mesh;
}

/// Of all lines, those between the first and the last row.
std::size_t inner_lines(const LineSet& lines, float last) {
    std::size_t count = 0;
    for (const Segment& s : lines.segments) {
        const float p = lines.vertices[s.p].y, q = lines.vertices[s.q].y;
        count += p > 0 && q > 0 && p < last && q < last ? 1 : 0;
    }
    return count;
}

TEST(LyingFaces, OfASheetWithTwoSidesAreOne) {
    const Mesh sheet = with_other_side(folded_sheet(4, 4), 4);
    EXPECT_EQ(extract_lines(sheet).segments.size(), 16U) << "its border";
    EXPECT_EQ(extract_lines(sheet, {.crease = 0.5F}).segments.size(), 16U + 24U);
}

TEST(LyingFaces, AreBentWhereTheSheetIs) {
    test::Random random{92};
    for (const Mesh& sheet :
         {with_other_side(folded_sheet(4, 2), 4),
          test::with_random_windings(with_other_side(folded_sheet(4, 2), 4), random)}) {
        const LineSet lines = extract_lines(sheet);
        EXPECT_EQ(lines.segments.size(), 16U + 4U);
        EXPECT_EQ(inner_lines(lines, 4), 2U + 2U * 2U) << "of the fold, and of both borders";
        EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 16U + 4U) << "folded back, and the fold";
    }
}

TEST(LyingFaces, StayThreeWhereThreeSheetsMeet) {
    Mesh mesh = with_other_side(folded_sheet(4, 2), 4);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{3, 1, 1}, {3, 2, 1}});
    mesh.triangles.push_back({5 + 2, 10 + 2, first}); // a fin on one edge of the fold
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 2U + 1U) << "of the fin, and where it stands";
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 16U + 3U);
}

TEST(LyingFaces, AreOfTheFirstsMaterialWhereOneIs) {
    // Of the front every other triangle comes before the back, and the rest after it.
    const Mesh front = folded_sheet(4, 4), both = with_other_side(front, 4);
    Mesh mesh = both;
    mesh.groups = {{.object = "", .material = "front"}, {.object = "", .material = "back"}};
    mesh.triangles.clear();
    const auto add = [&](std::size_t i) {
        mesh.triangles.push_back(both.triangles[i]);
        mesh.triangle_group.push_back(i < front.triangles.size() ? 0 : 1);
    };
    for (std::size_t i = 0; i < 32; i += 2) add(i);
    for (std::size_t i = 32; i < 64; ++i) add(i);
    for (std::size_t i = 1; i < 32; i += 2) add(i);
    const LineSet lines = extract_lines(mesh, {.lines = mask_of(LineKind::material)});
    EXPECT_EQ(lines.kind_counts[LA_KIND_MATERIAL], 16U) << "the border alone";
}

/// Boxes from one place to another, which share vertices where they touch.
struct Box {
    glm::vec3 low, high;
    const char* material;
};
Mesh boxes(const std::vector<Box>& all) {
    Mesh mesh;
    for (const Box& box : all) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int i = 0; i < 8; ++i)
            mesh.positions.push_back(
                glm::mix(box.low, box.high, glm::bvec3{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0}));
        constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
        for (const auto& f : faces) {
            mesh.triangles.push_back(glm::uvec3{f[0], f[1], f[2]} + first);
            mesh.triangles.push_back(glm::uvec3{f[0], f[2], f[3]} + first);
        }
        mesh.triangle_group.resize(mesh.triangles.size(),
                                   static_cast<std::uint32_t>(mesh.groups.size()));
        mesh.groups.push_back({.object = "", .material = box.material});
    }
    return mesh;
}

TEST(LyingFaces, BodiesThatAbutAreOne) {
    const Box left{{0, 0, 0}, {2, 3, 1}, "brick"};
    const LineSet same = extract_lines(boxes({left, {{2, 0, 0}, {5, 3, 1}, "brick"}}));
    // Of four edges each body has its part.
    EXPECT_EQ(same.kind_counts[LA_KIND_CREASE], 12U + 4U);
    EXPECT_EQ(same.segments.size(), 12U + 4U);
    const LineSet other = extract_lines(boxes({left, {{2, 0, 0}, {5, 3, 1}, "stone"}}));
    EXPECT_EQ(other.kind_counts[LA_KIND_CREASE], 12U + 4U);
    EXPECT_EQ(other.kind_counts[LA_KIND_MATERIAL], 4U);
    // Four tiles meet at edges of three bodies and more.
    const LineSet tiles = extract_lines(boxes({{{0, 0, 0}, {1, 1, 1}, "tile"},
                                               {{1, 0, 0}, {2, 1, 1}, "tile"},
                                               {{0, 1, 0}, {1, 2, 1}, "tile"},
                                               {{1, 1, 0}, {2, 2, 1}, "tile"}}));
    EXPECT_EQ(tiles.kind_counts[LA_KIND_CREASE], 4U + 2U * 8U + 1U)
        << "the last one is the middle, which four walls look at from all sides";
    EXPECT_EQ(tiles.segments.size(), tiles.kind_counts[LA_KIND_CREASE]);
}

TEST(LyingFaces, OfBodiesThatAllLookInwardsAreThoseOfBodiesThatDoNot) {
    const Mesh right = boxes({{{0, 0, 0}, {2, 3, 1}, "brick"},
                              {{2, 0, 0}, {5, 3, 1}, "brick"},
                              {{2, 3, 0}, {5, 4, 1}, "stone"}});
    Mesh turned = right;
    for (glm::uvec3& t : turned.triangles) std::swap(t.y, t.z);
    test::Random random{97};
    for (int round = 0; round < 20; ++round) {
        const glm::mat4 placed = random.placement(2);
        const LineSet lines = extract_lines(test::moved(right, placed));
        EXPECT_EQ(extract_lines(test::moved(turned, placed)).kind_counts, lines.kind_counts);
        EXPECT_EQ(lines.kind_counts[LA_KIND_MATERIAL], 3U);
    }
}

TEST(LyingFaces, WhereTwoPlacesAreOpenTheEdgeStays) {
    // Two that have an edge in common.
    const LineSet lines =
        extract_lines(boxes({{{0, 0, 0}, {1, 1, 1}, "a"}, {{1, 1, 0}, {2, 2, 1}, "a"}}));
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 22U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 1U);
    // A wall on a floor, both sheets: from below it is not seen, but from above it is.
    Mesh sheets;
    sheets.positions = {{0, 0, 0},  {0, 2, 0},  {1, 0, 0}, {1, 2, 0},
                        {-1, 0, 0}, {-1, 2, 0}, {0, 0, 1}, {0, 2, 1}};
    sheets.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 0, 1}, {4, 1, 5}, {0, 1, 7}, {0, 7, 6}};
    EXPECT_EQ(extract_lines(sheets).kind_counts[LA_KIND_BOUNDARY], 6U + 3U + 1U);
}

} // namespace
} // namespace lineatlas
