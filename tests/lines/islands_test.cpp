#include "lines/islands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lines/triangle_groups.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

void add(Mesh& mesh, const Mesh& part, const std::string& material = "steel") {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    const auto known = std::ranges::find(mesh.groups, material, &MeshGroup::material);
    const auto group = static_cast<std::uint32_t>(known - mesh.groups.begin());
    if (known == mesh.groups.end()) mesh.groups.push_back({.object = "", .material = material});
    for (const glm::uvec3& t : part.triangles) {
        mesh.triangles.push_back(t + first);
        mesh.triangle_group.push_back(group);
    }
}

Mesh box(glm::vec3 low, glm::vec3 high) {
    const glm::mat4 to_middle = glm::translate(glm::mat4{1}, 0.5F * (low + high));
    return test::moved(test::cube(), glm::scale(to_middle, 0.5F * (high - low)));
}

/// A block with another one that goes through it, one that ends in one plane with it along a part
/// of an edge, and a small one in a corner, so that no turn of it is like another.
Mesh machine(const glm::mat4& place, const std::string& of_small = "steel") {
    Mesh mesh;
    add(mesh, test::moved(box({-1, -1, -1}, {1, 1, 1}), place));
    add(mesh, test::moved(box({-0.3F, -0.4F, -2}, {0.5F, 0.2F, 2}), place));
    add(mesh, test::moved(box({1, -0.5F, 0.1F}, {2, 0.4F, 1}), place));
    add(mesh, test::moved(box({0.8F, 0.7F, 0.9F}, {1.1F, 1.2F, 1.3F}), place), of_small);
    return mesh;
}

glm::mat4 at(glm::vec3 place, float turn = 0, glm::vec3 size = glm::vec3{1}) {
    const glm::mat4 moved = glm::translate(glm::mat4{1}, place);
    return glm::scale(glm::rotate(moved, turn, {0.1F, 0.3F, 1}), size);
}

/// The islands of a mesh, with what they are made of.
struct Found {
    WeldedMesh mesh;
    std::vector<MeshEdge> edges;
    MeshParts parts;
    std::vector<std::uint32_t> materials, bodies;
    Islands islands;

    explicit Found(const Mesh& from, double reach = 0.1)
        : mesh(weld(from)), edges(mesh_edges(mesh)), parts(find_parts(mesh)),
          materials(materials_of(from.groups, mesh, {})),
          bodies(bodies_of(from.groups, mesh, materials, parts.of_vertex)),
          islands(mesh, edges, parts, {.materials = materials, .bodies = bodies, .objects = {}},
                  reach) {}

    /// Vertices of copies.
    std::ptrdiff_t copied() const {
        std::ptrdiff_t count = 0;
        for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) count += islands.is_copy(v);
        return count;
    }
};

Mesh both(const Mesh& one, const Mesh& other) {
    Mesh mesh;
    for (const Mesh* each : {&one, &other}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), each->positions.begin(), each->positions.end());
        for (const glm::uvec3& t : each->triangles) mesh.triangles.push_back(t + first);
        const auto group = static_cast<std::uint32_t>(mesh.groups.size());
        mesh.groups.insert(mesh.groups.end(), each->groups.begin(), each->groups.end());
        for (const std::uint32_t own : each->triangle_group)
            mesh.triangle_group.push_back(group + own);
    }
    return mesh;
}

constexpr std::ptrdiff_t corners = 32; // of a machine

TEST(Islands, ThatHaveOneShapeAreCopies) {
    const Mesh machines = both(machine(at({0, 0, 0})), machine(at({11, 3, 5}, 2.1F)));
    EXPECT_EQ(Found(both(machines, machine(at({-9, 4, 1000})))).copied(), 2 * corners);
}

TEST(Islands, ThatMayTouchAreOne) {
    const Mesh machines = both(machine(at({0, 0, 0})), machine(at({3.05F, 0, 0})));
    EXPECT_EQ(Found(machines, 0.1).copied(), 0);
    EXPECT_EQ(Found(machines, 0.01).copied(), corners);
}

TEST(Islands, ThatDifferInShapeAreNoCopies) {
    const Mesh one = machine(at({0, 0, 0}));
    EXPECT_EQ(Found(both(one, machine(at({11, 0, 0}, 0, {1, 1, 1.001F})))).copied(), 0);
    EXPECT_EQ(Found(both(one, machine(at({11, 0, 0}, 0, glm::vec3{2})))).copied(), 0);
    EXPECT_EQ(Found(both(one, machine(at({11, 0, 0}, 0, {-1, 1, 1})))).copied(), 0) << "mirrored";
    Mesh bent = machine(at({11, 0, 0}));
    bent.positions[13].x += 1e-4F;
    EXPECT_EQ(Found(both(one, bent)).copied(), 0);
    Mesh other_diagonal = machine(at({11, 0, 0}));
    std::swap(other_diagonal.triangles[0], other_diagonal.triangles[1]);
    EXPECT_EQ(Found(both(one, other_diagonal)).copied(), 0) << "other order";
}

/// A plate with a pad sunk into its top, or into its bottom.
Mesh plate(bool at_top, const glm::mat4& place) {
    const float z = at_top ? 2 : -1;
    Mesh mesh;
    add(mesh, test::moved(box({0, 0, 0}, {1000, 1000, 3}), place));
    add(mesh, test::moved(box({400, 300, z}, {500, 350, z + 2}), place));
    return mesh;
}

/// Far from zero, where floats are 1/64 apart, distances along a plate say little of heights.
TEST(Islands, ThatAreFlatAndFarFromZeroDifferBySides) {
    const glm::mat4 there = at({2e5F, -1e5F, 3e4F}), beside = at({1.9e5F, 1.7e5F, 2e4F}),
                    turned = at({1.8e5F, 1.6e5F, 1e4F}, 2.1F);
    const Mesh one = plate(true, there);
    EXPECT_EQ(Found(both(one, plate(false, beside)), 2).copied(), 0);
    EXPECT_EQ(Found(both(one, plate(false, turned)), 2).copied(), 0);
    EXPECT_EQ(Found(both(one, plate(true, beside)), 2).copied(), corners / 2);
    EXPECT_EQ(Found(both(one, plate(true, turned)), 2).copied(), corners / 2);
}

TEST(Islands, OfOtherMaterialsAreNoCopies) {
    const Mesh one = machine(at({0, 0, 0}));
    EXPECT_EQ(Found(both(one, machine(at({11, 0, 0}), "brass"))).copied(), 0);
    Mesh all_brass;
    add(all_brass, machine(at({11, 0, 0})), "brass");
    EXPECT_EQ(Found(both(one, all_brass)).copied(), corners) << "one material is like another";
}

/// Parts without a material are bodies of their own, and parts of one material are one body.
TEST(Islands, WithAndWithoutAMaterialAreNoCopies) {
    const Mesh named = machine(at({0, 0, 0})), other_named = machine(at({-11, 0, 0}));
    Mesh unnamed = machine(at({11, 0, 0})), other_unnamed = machine(at({22, 0, 0}));
    unnamed.groups = other_unnamed.groups = {{.object = "machine", .material = ""}};
    EXPECT_EQ(Found(both(named, unnamed)).copied(), 0);
    EXPECT_EQ(Found(both(unnamed, other_unnamed)).copied(), corners);
    const Mesh all = both(both(named, unnamed), both(other_named, other_unnamed));
    EXPECT_EQ(Found(all).copied(), 2 * corners);
}

TEST(Islands, WithPolylinesAreNoCopies) {
    Mesh machines = both(machine(at({0, 0, 0})), machine(at({11, 0, 0})));
    machines.polylines = {{0, 1}};
    EXPECT_EQ(Found(machines).copied(), 0);
}

TEST(Islands, WhoseEdgesAreOfOtherKindsAreToldApart) {
    const Mesh one = machine(at({0, 0, 0}));
    Found found{both(both(one, machine(at({11, 0, 0}))), machine(at({22, 0, 0})))};
    std::vector<std::optional<LineKind>> kinds(found.edges.size(), LineKind::crease);
    EXPECT_FALSE(found.islands.tell_apart(kinds));
    EXPECT_EQ(found.copied(), 2 * corners);
    kinds.back() = LineKind::boundary;
    EXPECT_TRUE(found.islands.tell_apart(kinds));
    EXPECT_EQ(found.copied(), corners);
}

/// The lines of a kind, by their ends in a place of their own.
std::vector<std::array<glm::vec3, 2>> lines_of(const LineSet& lines, LineKind kind,
                                               const glm::mat4& place) {
    const glm::mat4 back = glm::inverse(place);
    const auto end = [&](std::uint32_t vertex) {
        return glm::vec3{back * glm::vec4{lines.vertices[vertex], 1}};
    };
    std::vector<std::array<glm::vec3, 2>> found;
    for (const Segment& s : lines.segments) {
        if ((s.tag & LA_TAG_KIND_MASK) != static_cast<std::uint32_t>(kind)) continue;
        std::array<glm::vec3, 2> ends{end(s.p), end(s.q)};
        if (glm::length(ends[0]) < 5 && glm::length(ends[1]) < 5) found.push_back(ends);
    }
    return found;
}

bool is_among(const std::array<glm::vec3, 2>& line,
              const std::vector<std::array<glm::vec3, 2>>& lines) {
    constexpr float rounding = 1e-4F;
    return std::ranges::any_of(lines, [&](const auto& other) {
        const auto near = [&](std::size_t a, std::size_t b) {
            return glm::distance(line[0], other[a]) < rounding &&
                   glm::distance(line[1], other[b]) < rounding;
        };
        return near(0, 1) || near(1, 0);
    });
}

/// Each machine has the lines that it has alone.
void expect_lines_of_each(const std::vector<Mesh>& machines, const std::vector<glm::mat4>& places,
                          const LineSet& all) {
    for (std::size_t i = 0; i < machines.size(); ++i) {
        const LineSet alone = extract_lines(machines[i]);
        for (const LineKind kind : {LineKind::crease, LineKind::intersection}) {
            const auto own = lines_of(all, kind, places[i]);
            const auto expected = lines_of(alone, kind, places[i]);
            ASSERT_FALSE(expected.empty());
            EXPECT_EQ(own.size(), expected.size()) << i;
            for (const auto& line : own) EXPECT_TRUE(is_among(line, expected)) << i;
            for (const auto& line : expected) EXPECT_TRUE(is_among(line, own)) << i;
        }
    }
}

Mesh all_of(const std::vector<Mesh>& machines) {
    Mesh mesh = machines.front();
    for (std::size_t i = 1; i < machines.size(); ++i) mesh = both(mesh, machines[i]);
    return mesh;
}

TEST(Islands, HaveTheLinesThatTheyHaveAlone) {
    const std::vector places{at({0, 0, 0}), at({11, 3, 5}, 2.1F), at({-20, 7, 3}, -0.4F)};
    std::vector<Mesh> machines;
    for (const glm::mat4& place : places) machines.push_back(machine(place));
    const Mesh mesh = all_of(machines);
    ASSERT_EQ(Found(mesh).copied(), 2 * corners);
    const LineSet all = extract_lines(mesh);
    expect_lines_of_each(machines, places, all);
    const std::size_t cut_seams = extract_lines(machines[0]).left_out.cut_seams;
    EXPECT_GT(cut_seams, 0U);
    EXPECT_EQ(all.left_out.cut_seams, 3 * cut_seams);
}

/// More originals of one size than are compared: the others have their lines without them.
TEST(Islands, OfManyShapesHaveTheLinesThatTheyHaveAlone) {
    constexpr int shapes = 10, compared = 8;
    std::vector<glm::mat4> places;
    std::vector<Mesh> machines;
    for (int i = 0; i < 2 * shapes; ++i) {
        const int shape = i % shapes;
        places.push_back(at({12 * (i % 5), 12 * (i / 5), 0}, i < shapes ? 0.0F : 0.7F,
                            {1, 1, 1 + 0.02F * static_cast<float>(shape)}));
        machines.push_back(machine(places.back()));
    }
    const Mesh mesh = all_of(machines);
    EXPECT_EQ(Found(mesh).copied(), compared * corners);
    expect_lines_of_each(machines, places, extract_lines(mesh));
}

/// Lines of intersections lie in their triangles, in copies as well.
TEST(Islands, HaveIntersectionsInTheirOwnTriangles) {
    const LineSet lines =
        extract_lines(both(machine(at({0, 0, 0})), machine(at({11, 3, 5}, 2.1F))));
    std::size_t count = 0;
    for (const Segment& s : lines.segments) {
        if ((s.tag & LA_TAG_KIND_MASK) != LA_KIND_INTERSECTION) continue;
        ++count;
        for (const std::uint32_t face : {s.face_a, s.face_b}) {
            const glm::uvec3 t = lines.triangles[face];
            const glm::vec3 a = lines.vertices[t.x];
            const glm::vec3 normal =
                glm::normalize(glm::cross(lines.vertices[t.y] - a, lines.vertices[t.z] - a));
            for (const std::uint32_t end : {s.p, s.q})
                EXPECT_LT(std::abs(glm::dot(normal, lines.vertices[end] - a)), 1e-4F);
        }
    }
    EXPECT_GT(count, 0U);
}

} // namespace
} // namespace lineatlas
