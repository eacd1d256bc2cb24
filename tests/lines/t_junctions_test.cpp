#include "lines/t_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "lineatlas/lines.hpp"

namespace lineatlas {
namespace {

void add_triangle(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
}

/// Panels on either side of a line from 0 to 4, bent at the line by an angle in degrees. The lists
/// tell where the panels of each side end.
Mesh folded_sheet(double bend, const std::vector<float>& below, const std::vector<float>& above,
                  float off = 0) {
    Mesh mesh;
    const double angle = bend * std::numbers::pi / 180;
    const auto up = [&](float x) {
        return glm::vec3{x, static_cast<float>(std::cos(angle)),
                         static_cast<float>(std::sin(angle))};
    };
    for (std::size_t i = 1; i < below.size(); ++i) {
        const float from = below[i - 1], to = below[i];
        const float end = to == below.back() ? 0 : off; // only the ends are common
        const float begin = i == 1 ? 0 : off;
        add_triangle(mesh, {from, -1, 0}, {to, -1, 0}, {to, end, 0});
        add_triangle(mesh, {from, -1, 0}, {to, end, 0}, {from, begin, 0});
    }
    for (std::size_t i = 1; i < above.size(); ++i) {
        const float from = above[i - 1], to = above[i];
        add_triangle(mesh, {from, 0, 0}, {to, 0, 0}, up(to));
        add_triangle(mesh, {from, 0, 0}, up(to), up(from));
    }
    return mesh;
}

std::size_t boundaries_of(const WeldedMesh& mesh) {
    const std::vector<MeshEdge> edges = mesh_edges(mesh);
    return static_cast<std::size_t>(std::ranges::count(edges, 1U, &MeshEdge::face_count));
}

TEST(TJunctions, AreWhatTheBendSays) {
    for (const double bend : {0.0, 5.0, 10.0, 20.0, 45.0, 90.0}) {
        const LineSet lines = extract_lines(folded_sheet(bend, {0, 2, 4}, {0, 4}));
        EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], bend > 28.8 ? 2U : 0U) << bend;
        EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 7U) << bend << ": its outline";
        EXPECT_EQ(lines.left_out.cracks, 1U) << bend;
    }
}

TEST(TJunctions, AreSilhouettesWhereNothingElse) {
    const LineSet lines = extract_lines(folded_sheet(20, {0, 2, 4}, {0, 4}));
    std::size_t between = 0;
    for (const Segment& segment : lines.segments)
        if ((segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE)
            between += lines.vertices[segment.p].y == 0 && lines.vertices[segment.q].y == 0;
    EXPECT_EQ(between, 2U);
}

TEST(TJunctions, OfBricksAreClosedOnBothSides) {
    WeldedMesh mesh = weld(folded_sheet(60, {0, 1, 3, 4}, {0, 2, 4}));
    EXPECT_EQ(close_t_junctions(mesh, mesh_edges(mesh)), 3U);
    EXPECT_EQ(mesh.triangles.size(), 10U + 3);
    EXPECT_EQ(boundaries_of(mesh), 4U + 5);
    EXPECT_EQ(close_t_junctions(mesh, mesh_edges(mesh)), 0U);
}

TEST(TJunctions, StandBesideTheLineByLittle) {
    for (const float off : {2e-5F, 2e-4F}) { // 0.001 % of the diagonal are 4.5e-5
        WeldedMesh mesh = weld(folded_sheet(0, {0, 2, 4}, {0, 4}, off));
        EXPECT_EQ(close_t_junctions(mesh, mesh_edges(mesh)), off < 1e-4F ? 1U : 0U) << off;
    }
}

/// Four small triangles around a large one. All but one of the large one's sides have two corners
/// within.
TEST(TJunctions, OfATriangleMayBeOnSeveralSides) {
    Mesh mesh;
    const std::array<glm::vec3, 3> corners{glm::vec3{0, 0, 0}, {6, 0, 0}, {0, 6, 0}};
    add_triangle(mesh, corners[0], corners[1], corners[2]);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec3 from = corners[k], to = corners[(k + 1) % 3];
        const glm::vec3 out = glm::cross(to - from, glm::vec3{0, 0, 1}) * 0.2F;
        const int parts = k == 1 ? 1 : 3;
        for (int i = 0; i < parts; ++i) {
            const glm::vec3 a = from + (to - from) * (static_cast<float>(i) / parts);
            const glm::vec3 b = from + (to - from) * (static_cast<float>(i + 1) / parts);
            add_triangle(mesh, b, a, 0.5F * (a + b) + out);
        }
    }
    WeldedMesh welded = weld(mesh);
    EXPECT_EQ(close_t_junctions(welded, mesh_edges(welded)), 4U);
    EXPECT_EQ(welded.triangles.size(), 8U + 4);
    EXPECT_EQ(boundaries_of(welded), 7U * 2);
    double area = 0;
    for (std::size_t i = 0; i < welded.triangles.size(); ++i) {
        const glm::uvec3 t = welded.triangles[i];
        const glm::vec3 across = glm::cross(welded.vertices[t.y] - welded.vertices[t.x],
                                            welded.vertices[t.z] - welded.vertices[t.x]);
        EXPECT_GT(across.z, 0) << i;
        if (welded.triangle_source[i] == 0) area += 0.5 * across.z;
    }
    EXPECT_NEAR(area, 18, 1e-5);
    EXPECT_EQ(std::ranges::count(welded.triangle_source, 0U), 5);
}

TEST(TJunctions, AreLeftWhereACornerMeetsAnAngle) {
    Mesh mesh; // the second triangle stands on a point of the first one's side
    add_triangle(mesh, {0, 0, 0}, {4, 0, 0}, {2, 2, 0});
    add_triangle(mesh, {2, 0, 0}, {3, -2, 0}, {1, -2, 0});
    WeldedMesh welded = weld(mesh);
    EXPECT_EQ(close_t_junctions(welded, mesh_edges(welded)), 0U);
}

TEST(TJunctions, OfSeparateObjectsStay) {
    Mesh mesh = folded_sheet(0, {0, 2, 4}, {0, 4});
    mesh.triangle_object = {0, 0, 0, 0, 1, 1};
    EXPECT_EQ(extract_lines(mesh, {.separate_objects = true}).left_out.cracks, 0U);
}

TEST(TJunctions, StayWhereAnAngleIsGiven) {
    const LineSet lines = extract_lines(folded_sheet(45, {0, 2, 4}, {0, 4}), {.crease = 0.5F});
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 7U + 3);
}

} // namespace
} // namespace lineatlas
