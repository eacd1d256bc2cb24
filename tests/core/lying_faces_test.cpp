#include "core/lying_faces.hpp"

#include <vector>

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
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_MATERIAL], 16U) << "the border alone";
}

} // namespace
} // namespace lineatlas
