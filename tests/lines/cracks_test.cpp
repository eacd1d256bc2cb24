#include "lines/cracks.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "base/vertex_sets.hpp"
#include "lineatlas/lines.hpp"
#include "lines/diagonal.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

/// Adds a rectangle with corners of its own.
void add_panel(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
    mesh.triangles.insert(mesh.triangles.end(),
                          {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
}

/// The open mantle of a prism with a radius and a height of 1. Its diagonal is 3.
Mesh mantle(int sides, float off) {
    test::Random random{91};
    Mesh mesh;
    const auto corner = [&](int i, float y) {
        const double angle = 2 * std::numbers::pi * (i % sides) / sides;
        return glm::vec3{static_cast<float>(std::cos(angle)), y,
                         static_cast<float>(-std::sin(angle))} +
               glm::vec3{random.between(-off, off), random.between(-off, off),
                         random.between(-off, off)};
    };
    for (int i = 0; i < sides; ++i)
        add_panel(mesh, corner(i, 0), corner(i + 1, 0), corner(i + 1, 1), corner(i, 1));
    return mesh;
}

/// Two squares that would meet at a right angle without the gap.
Mesh corner_of_squares(float gap, float size = 1) {
    Mesh mesh;
    add_panel(mesh, {0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0});
    add_panel(mesh, {-gap, 0, 0}, {-gap, size, 0}, {-gap, size, size}, {-gap, 0, size});
    return mesh;
}

TEST(Cracks, OfAMantleOfPanelsAreClosed) {
    for (const float off : {1e-7F, 1e-6F, 5e-6F}) {
        const LineSet lines = extract_lines(mantle(24, off));
        EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 48U) << off << ": its two rims";
        EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 0U) << off;
        EXPECT_GE(lines.kind_counts[LA_KIND_SILHOUETTE], 24U) << off << ": where panels meet";
    }
}

TEST(Cracks, OfACornerBecomeItsCrease) {
    const LineSet lines = extract_lines(corner_of_squares(1e-6F));
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 6U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 1U);
    EXPECT_EQ(lines.left_out.cracks, 1U);
}

TEST(Cracks, AreClosedWhateverTheWindings) {
    Mesh mesh = corner_of_squares(1e-6F);
    std::swap(mesh.triangles[2].y, mesh.triangles[2].z);
    std::swap(mesh.triangles[3].y, mesh.triangles[3].z);
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_CREASE], 1U);
}

TEST(Cracks, ThatAreWiderStayOpen) {
    EXPECT_EQ(extract_lines(corner_of_squares(2e-4F)).kind_counts[LA_KIND_BOUNDARY], 8U);
}

TEST(Cracks, ThatAreWideForTheirEdgesStayOpen) {
    // The same corner in a model that is ten thousand times as large.
    Mesh mesh = corner_of_squares(1e-2F);
    add_panel(mesh, {6000, 0, 0}, {6100, 0, 0}, {6100, 8000, 0}, {6000, 8000, 0});
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_BOUNDARY], 8U + 4U);
}

TEST(Cracks, StayOpenWhereAnAngleIsGiven) {
    const LineSet lines = extract_lines(corner_of_squares(1e-6F), {.crease = 0.5F});
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 8U);
    EXPECT_EQ(lines.left_out.cracks, 0U);
}

TEST(Cracks, AreNoneBetweenObjectsThatMove) {
    Mesh mesh = corner_of_squares(1e-6F);
    mesh.groups = {{.object = "floor", .material = ""}, {.object = "door", .material = ""}};
    mesh.triangle_group = {0, 0, 1, 1};
    EXPECT_EQ(extract_lines(mesh, {.separate_objects = true}).kind_counts[LA_KIND_BOUNDARY], 8U);
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_BOUNDARY], 6U);
}

TEST(Cracks, AreAsWideAsTheFileIsPrecise) {
    Mesh mesh = corner_of_squares(3e-3F);
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_BOUNDARY], 8U);
    mesh.precision = 2e-3F;
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_BOUNDARY], 6U);
}

TEST(Cracks, OfManySheetsInOnePlaceAreClosedOnceEach) {
    // Each sheet lies on all others. The number of pairs would be a hundred times as large.
    test::Random random{97};
    constexpr std::size_t sheets = 400;
    const auto corner = [&](glm::vec3 at) { return at + random.point(1e-6F); };
    Mesh mesh;
    for (std::uint32_t i = 0; i < sheets; ++i) {
        mesh.positions.insert(mesh.positions.end(),
                              {corner({0, 0, 0}), corner({1, 0, 0}), corner({0, 1, 0})});
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.left_out.cracks, 3 * (sheets - 1));
    EXPECT_EQ(lines.segments.size(), 3U);
}

TEST(Cracks, AreClosedAsIfAllPairsWereCompared) {
    // Edges as far apart as the widest crack. Which of them are joined depends on all edges
    // between.
    test::Random random{98};
    for (int round = 0; round < 20; ++round) {
        const float widest = 1e-5F * std::sqrt(3.0F);
        Mesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 1, 1}}; // fixes the diagonal
        std::vector<std::array<glm::vec3, 2>> edges;
        for (std::uint32_t i = 0; i < 60; ++i) {
            const glm::vec3 p = glm::vec3{0.3F} + random.point(2 * widest);
            const glm::vec3 q = glm::vec3{0.3F, 0.3F, 0.7F} + random.point(2 * widest);
            edges.push_back({p, q});
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            const float turn = 0.1F * static_cast<float>(i);
            const glm::vec3 apex =
                glm::vec3{0.3F + 0.2F * std::cos(turn), 0.3F + 0.2F * std::sin(turn), 0.5F};
            mesh.positions.insert(mesh.positions.end(),
                                  {i % 2 == 0 ? p : q, i % 2 == 0 ? q : p, apex});
            mesh.triangles.emplace_back(first, first + 1, first + 2);
        }
        mesh.polylines = {{0, 1}};
        WeldedMesh welded = weld(mesh);
        VertexSets expected{edges.size()};
        std::size_t closed = 0;
        for (std::uint32_t a = 0; a < edges.size(); ++a) {
            for (std::uint32_t b = 0; b < a; ++b) {
                const auto apart = [&](int end) {
                    return glm::distance(glm::dvec3{edges[a][end]}, glm::dvec3{edges[b][end]});
                };
                const double most = 1e-5 * diagonal_of(welded.vertices);
                if (apart(0) > most || apart(1) > most) continue;
                closed += expected.find(a) != expected.find(b) ? 1 : 0;
                expected.unite(a, b);
            }
        }
        EXPECT_EQ(close_cracks(welded, mesh_edges(welded)), closed);
        for (std::uint32_t a = 0; a < edges.size(); ++a) {
            for (std::uint32_t b = 0; b < a; ++b)
                EXPECT_EQ(welded.triangles[a][a % 2] == welded.triangles[b][b % 2],
                          expected.find(a) == expected.find(b));
        }
    }
}

TEST(Cracks, TakeASliverBesideThemAlong) {
    // A triangle whose short side bridges the gap has no room when the gap is closed.
    Mesh mesh = corner_of_squares(1e-6F);
    mesh.triangles.emplace_back(0, 4, 7);
    WeldedMesh welded = weld(mesh);
    ASSERT_EQ(close_cracks(welded, mesh_edges(welded)), 1U);
    EXPECT_EQ(welded.triangles.size(), 4U);
    EXPECT_EQ(welded.triangle_source, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(welded.odd.collapsed, 1U);
    EXPECT_EQ(close_cracks(welded, mesh_edges(welded)), 0U);
}

} // namespace
} // namespace lineatlas
