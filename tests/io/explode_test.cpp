// Exploded parts are at the computed places.
#include "lineatlas/explode.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {
namespace {

/// Adds a box of 2 by 2 by 2 about a place, as another object.
void add_box(LoadedMesh& model, glm::vec3 middle, std::uint32_t object) {
    Mesh& mesh = model.mesh;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.push_back(middle + glm::vec3{(corner & 1) != 0 ? 1 : -1,
                                                    (corner & 2) != 0 ? 1 : -1,
                                                    (corner & 4) != 0 ? 1 : -1});
    constexpr std::array<glm::uvec4, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const glm::uvec4 side : sides) {
        mesh.triangles.emplace_back(first + side.x, first + side.y, first + side.z);
        mesh.triangles.emplace_back(first + side.x, first + side.z, first + side.w);
        mesh.triangle_object.insert(mesh.triangle_object.end(), 2, object);
    }
}

/// A base about 0, and an arm of two bolts about x = 10 and x = 20. The middle of the arm is at 15,
/// that of the whole at 10.
LoadedMesh robot() {
    LoadedMesh model;
    model.parts = {{.name = "robot"},
                   {.name = "base", .parent = 0, .object = 0},
                   {.name = "arm", .parent = 0},
                   {.name = "Bolt 1", .parent = 2, .object = 1},
                   {.name = "Bolt 2", .parent = 2, .object = 2}};
    add_box(model, {0, 0, 0}, 0);
    add_box(model, {10, 0, 0}, 1);
    add_box(model, {20, 0, 0}, 2);
    return model;
}

glm::vec3 middle_of(const LoadedMesh& model, std::size_t box) {
    return 0.5F * (model.mesh.positions[8 * box] + model.mesh.positions[8 * box + 7]);
}

/// The trails, each from one x to another.
std::vector<std::array<float, 2>> trails(const LoadedMesh& model) {
    std::vector<std::array<float, 2>> found;
    for (std::size_t i = 0; i < model.mesh.polylines.size(); ++i) {
        if (model.mesh.polyline_kind[i] != PolylineKind::trail) continue;
        const std::vector<std::uint32_t>& line = model.mesh.polylines[i];
        EXPECT_EQ(line.size(), 2U);
        found.push_back({model.mesh.positions[line[0]].x, model.mesh.positions[line[1]].x});
    }
    return found;
}

TEST(Explode, MovesPartsFromTheMiddleOfTheirAssembly) {
    LoadedMesh model = robot();
    explode(model, {.factor = 2});
    EXPECT_EQ(middle_of(model, 0), glm::vec3(-10, 0, 0));
    // The arm moves by 5 to the right, and its bolts by another 5 to either side.
    EXPECT_EQ(middle_of(model, 1), glm::vec3(10, 0, 0));
    EXPECT_EQ(middle_of(model, 2), glm::vec3(30, 0, 0));
    EXPECT_EQ(trails(model),
              (std::vector<std::array<float, 2>>{{0, -10}, {15, 20}, {15, 10}, {25, 30}}));
    const LineSet lines = extract_lines(model.mesh);
    EXPECT_EQ(lines.kind_counts[LA_KIND_TRAIL], 4U);
}

TEST(Explode, AFactorOfOneMovesNothing) {
    LoadedMesh model = robot();
    explode(model, {});
    EXPECT_EQ(model.mesh.positions, robot().mesh.positions);
    EXPECT_TRUE(model.mesh.polylines.empty());
}

TEST(Explode, MovesByHandGoBeforeTheFactor) {
    LoadedMesh model = robot();
    explode(model, {.factor = 2, .moves = {{"Bolt*", {0, 7, 0}}, {"arm/Bolt ?", {0, 0, 3}}}});
    EXPECT_EQ(middle_of(model, 1), glm::vec3(15, 0, 3)) << "the last one that names it";
    LoadedMesh whole = robot();
    explode(whole, {.moves = {{"arm", {0, 9, 0}}}, .trails = false});
    EXPECT_EQ(middle_of(whole, 0), glm::vec3(0, 0, 0));
    EXPECT_EQ(middle_of(whole, 1), glm::vec3(10, 9, 0)) << "with what is in it, once";
    EXPECT_TRUE(whole.mesh.polylines.empty());
}

TEST(Explode, WithoutATreeGroupsAreParts) {
    LoadedMesh model = robot();
    model.parts.clear();
    model.mesh.triangle_object.clear();
    model.mesh.groups = {{"a", ""}, {"b", ""}, {"c", ""}};
    for (std::uint32_t i = 0; i < 36; ++i) model.mesh.triangle_group.push_back(i / 12);
    explode(model, {.factor = 1.5});
    EXPECT_EQ(middle_of(model, 0), glm::vec3(-5, 0, 0));
    EXPECT_EQ(middle_of(model, 1), glm::vec3(10, 0, 0));
    EXPECT_EQ(middle_of(model, 2), glm::vec3(25, 0, 0));
}

TEST(Explode, PositionsThatPartsShareBecomeSeveral) {
    LoadedMesh model;
    model.mesh = {.positions = {{0, 0, 0}, {0, 1, 0}, {-2, 0, 0}, {2, 0, 0}},
                  .triangles = {{0, 1, 2}, {0, 1, 3}},
                  .triangle_group = {0, 1},
                  .groups = {{"left", ""}, {"right", ""}},
                  .polylines = {}};
    explode(model, {.factor = 3});
    const glm::uvec3 left = model.mesh.triangles[0], right = model.mesh.triangles[1];
    EXPECT_EQ(model.mesh.positions[left.x], glm::vec3(-2, 0, 0));
    EXPECT_EQ(model.mesh.positions[right.x], glm::vec3(2, 0, 0));
}

TEST(Explode, SurfacesAndCurvesGoWithTheirParts) {
    LoadedMesh model = robot();
    Mesh& mesh = model.mesh;
    mesh.surfaces.shapes.resize(1);
    mesh.surfaces.surfaces.resize(1);
    // One surface for all parts, so that each part gets its own.
    mesh.surfaces.of_triangle.assign(36, 0);
    mesh.surfaces.parameters.resize(36);
    mesh.known_edges = {{16, 17, KnownEdge::Kind::sharp, 0}};
    mesh.edge_curves = {EdgeCurve{.center = {20, 0, 0}, .u = {1, 0, 0}, .v = {0, 1, 0}}};
    explode(model, {.factor = 2});
    ASSERT_EQ(mesh.surfaces.surfaces.size(), 3U);
    const std::uint32_t last = mesh.surfaces.of_triangle.back();
    EXPECT_EQ(mesh.surfaces.surfaces[last].model_from_shape[3], glm::dvec3(10, 0, 0));
    EXPECT_EQ(mesh.edge_curves[0]->center, glm::dvec3(30, 0, 0));
}

TEST(Explode, RefusesWhatCannotBe) {
    LoadedMesh model = robot();
    for (const double factor : {0.5, 101.0, std::nan("")})
        EXPECT_THROW(explode(model, {.factor = factor}), UsageError);
    EXPECT_THROW(explode(model, {.moves = {{"nut*", {1, 0, 0}}}}), UsageError);
    EXPECT_THROW(explode(model, {.moves = {{"arm", {INFINITY, 0, 0}}}}), UsageError);
    EXPECT_EQ(model.mesh.positions, robot().mesh.positions);
}

} // namespace
} // namespace lineatlas
