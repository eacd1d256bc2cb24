#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lineatlas/lines.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

std::uint32_t add_group(Mesh& mesh, const std::string& material) {
    for (std::uint32_t i = 0; i < mesh.groups.size(); ++i)
        if (mesh.groups[i].material == material) return i;
    mesh.groups.push_back({.object = "", .material = material});
    return static_cast<std::uint32_t>(mesh.groups.size() - 1);
}

/// A rectangle of two triangles, with corners of its own, from `at` along `u` and `v`.
void add_rectangle(Mesh& mesh, glm::vec3 at, glm::vec3 u, glm::vec3 v,
                   const std::string& material = "stone") {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {at, at + u, at + u + v, at + v});
    mesh.triangles.insert(mesh.triangles.end(),
                          {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    mesh.triangle_group.insert(mesh.triangle_group.end(), 2, add_group(mesh, material));
}

void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 size, const std::string& material = "stone") {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Mesh cube = test::cube();
    for (const glm::vec3& p : cube.positions)
        mesh.positions.push_back(low + 0.5F * (p + 1.0F) * size);
    for (const glm::uvec3& t : cube.triangles) {
        mesh.triangles.push_back(t + first);
        mesh.triangle_group.push_back(add_group(mesh, material));
    }
}

/// The length of the lines of a kind.
double length_of(const LineSet& lines, LineKind kind) {
    double length = 0;
    for (const Segment& s : lines.segments) {
        if ((s.tag & LA_TAG_KIND_MASK) == static_cast<std::uint32_t>(kind))
            length += static_cast<double>(glm::distance(lines.vertices[s.p], lines.vertices[s.q]));
    }
    return length;
}

TEST(Seams, OfTwoSquaresSideBySideAreTheirCommonEdge) {
    Mesh mesh;
    add_rectangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_rectangle(mesh, {1.0001F, 0, 0}, {1, 0, 0}, {0, 1, 0}); // not welded
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.left_out.seams, 2U);
    EXPECT_EQ(lines.left_out.cut_seams, 0U);
    EXPECT_NEAR(length_of(lines, LineKind::boundary), 6, 1e-4);
    EXPECT_TRUE(lines.cut_vertices.empty());
}

TEST(Seams, StayWhereAnAngleIsGiven) {
    Mesh mesh;
    add_rectangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_rectangle(mesh, {1.0001F, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const LineSet lines = extract_lines(mesh, {.crease = 0.5F});
    EXPECT_EQ(lines.left_out.seams, 0U);
    EXPECT_NEAR(length_of(lines, LineKind::boundary), 8, 1e-4);
}

TEST(Seams, AreNoneBetweenMaterials) {
    Mesh mesh;
    add_rectangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_rectangle(mesh, {1.0001F, 0, 0}, {1, 0, 0}, {0, 1, 0}, "glass");
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.left_out.seams, 0U);
    EXPECT_NEAR(length_of(lines, LineKind::boundary), 8, 1e-4);
}

TEST(Seams, AreNoneBetweenNamedObjectsWithoutMaterials) {
    for (const bool same : {false, true}) {
        Mesh mesh;
        add_rectangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, "a");
        add_rectangle(mesh, {1.0001F, 0, 0}, {1, 0, 0}, {0, 1, 0}, "b");
        mesh.groups = {{.object = "a", .material = ""},
                       {.object = same ? "a" : "b", .material = ""}};
        EXPECT_EQ(extract_lines(mesh).left_out.seams, same ? 2U : 0U);
    }
}

TEST(Seams, AreNoneWhereTheSurfaceTurnsOrStops) {
    for (const glm::vec3 v : {glm::vec3{0, 0, 1}, glm::vec3{1, 0, 0.1F}}) { // up; by 6 degrees
        Mesh mesh;
        add_rectangle(mesh, {0, 0, 0}, {-1, 0, 0}, {0, 1, 0});
        add_rectangle(mesh, {0.00001F, 0, 0}, v, {0, 1, 0});
        EXPECT_EQ(extract_lines(mesh).left_out.seams, 0U);
    }
    Mesh apart;
    add_rectangle(apart, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_rectangle(apart, {1.01F, 0, 0}, {1, 0, 0}, {0, 1, 0});
    EXPECT_EQ(extract_lines(apart).left_out.seams, 0U);
    Mesh step;
    add_rectangle(step, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_rectangle(step, {1, 0, 0.01F}, {1, 0, 0}, {0, 1, 0});
    EXPECT_EQ(extract_lines(step).left_out.seams, 0U);
}

/// A square beside a larger one. Only the middle half of the larger one's edge is a seam.
TEST(Seams, AreThePartOfAnEdgeWhereASmallerFaceGoesOn) {
    Mesh mesh;
    add_rectangle(mesh, {0, 0, 0}, {2, 0, 0}, {0, 4, 0});
    add_rectangle(mesh, {2, 1, 0}, {2, 0, 0}, {0, 2, 0});
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.left_out.seams, 1U);
    EXPECT_EQ(lines.left_out.cut_seams, 1U);
    EXPECT_NEAR(length_of(lines, LineKind::boundary), 20 - 2 - 2, 0.01);
    for (const Segment& s : lines.segments) {
        const glm::vec3 p = lines.vertices[s.p], q = lines.vertices[s.q];
        if (p.x != 2 || q.x != 2) continue;
        EXPECT_FALSE(std::min(p.y, q.y) < 2 && std::max(p.y, q.y) > 2) << "across the seam";
        EXPECT_EQ(s.face_b, LA_NO_FACE);
        EXPECT_LT(s.face_a, 2U) << "of the larger one";
    }
    for (const CutVertex& cut : lines.cut_vertices) {
        const glm::vec3 from = lines.vertices[cut.from], to = lines.vertices[cut.to];
        EXPECT_LT(glm::distance(glm::mix(from, to, cut.share), lines.vertices[cut.vertex]), 1e-6F);
        EXPECT_NEAR(lines.vertices[cut.vertex].x, 2, 1e-6);
    }
}

/// Two boxes side by side. With one material no line shows where they touch, and the outer edges
/// continue. With different materials the border between them shows.
TEST(Seams, OfBoxesSideBySideAreTheirEdgesThere) {
    Mesh mesh;
    add_box(mesh, {0, 0, 0}, {1, 1, 1});
    add_box(mesh, {1.00001F, 0, 0}, {1, 1, 1});
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.left_out.seams, 8U);
    EXPECT_NEAR(length_of(lines, LineKind::crease), 4 * 2 + 8 * 1, 1e-4);
    EXPECT_EQ(length_of(lines, LineKind::silhouette), 0) << "nor are they silhouettes";
    EXPECT_EQ(lines.kind_counts[LA_KIND_INTERSECTION], 0U) << "they only touch";

    Mesh two;
    add_box(two, {0, 0, 0}, {1, 1, 1});
    add_box(two, {1.00001F, 0, 0}, {1, 1, 1}, "glass");
    EXPECT_EQ(extract_lines(two).left_out.seams, 0U);
}

/// A box on a floor of the same material keeps the edges at its foot.
TEST(Seams, AreNotAtTheFootOfABox) {
    Mesh mesh;
    add_rectangle(mesh, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0});
    add_box(mesh, {-1, -1, 0}, {2, 2, 2});
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.left_out.seams, 0U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 12U);
}

TEST(Seams, AreWithinObjectsThatMove) {
    Mesh mesh;
    add_rectangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    add_rectangle(mesh, {1, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.triangle_object = {0, 0, 1, 1};
    EXPECT_EQ(extract_lines(mesh, {.separate_objects = true}).left_out.seams, 0U);
}

TEST(Seams, AreWhereTheyAreInAnyPlaceAndSize) {
    Mesh mesh;
    add_rectangle(mesh, {0, 0, 0}, {2, 0, 0}, {0, 4, 0});
    add_rectangle(mesh, {2, 1, 0}, {2, 0, 0}, {0, 2, 0});
    test::Random random{95};
    for (int round = 0; round < 30; ++round) {
        const float size = std::exp2(static_cast<float>(random.below(30)) - 15);
        const glm::mat4 scaled = glm::scale(glm::mat4{1}, glm::vec3{size});
        const LineSet lines = extract_lines(test::moved(mesh, scaled * random.placement(2)));
        EXPECT_EQ(lines.left_out.seams, 1U);
        EXPECT_EQ(lines.left_out.cut_seams, 1U);
    }
}

TEST(Seams, OfAnObjectAreWhateverStandsBesideIt) {
    // The top of a box goes on. The box beside it may move away.
    std::array<double, 2> lengths{};
    for (const bool stands_beside : {false, true}) {
        Mesh mesh;
        add_box(mesh, {0, 0, 0}, {1, 1, 1});
        add_rectangle(mesh, {1.0001F, 0, 1}, {1, 0, 0}, {0, 1, 0}); // not welded
        mesh.triangle_object.assign(mesh.triangles.size(), 0);
        add_box(mesh, {stands_beside ? 1.0F : 1.5F, 0, 0}, {0.4F, 1, 0.9999F}, "wood");
        mesh.triangle_object.resize(mesh.triangles.size(), 1);
        lengths[stands_beside ? 1 : 0] =
            length_of(extract_lines(mesh, {.separate_objects = true}), LineKind::crease);
    }
    EXPECT_NEAR(lengths[0], lengths[1], 1e-4);
}

} // namespace
} // namespace lineatlas
