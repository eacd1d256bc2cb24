#include "lines/buried_faces.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "lines/diagonal.hpp"
#include "lines/triangle_tree.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

void add(Mesh& mesh, const Mesh& part) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const glm::uvec3& t : part.triangles) mesh.triangles.push_back(t + first);
}

Mesh box(glm::vec3 low, glm::vec3 high) {
    const glm::mat4 to_middle = glm::translate(glm::mat4{1}, 0.5F * (low + high));
    return test::moved(test::cube(), glm::scale(to_middle, 0.5F * (high - low)));
}

/// A block from far on the left to `right` that is larger than the ball on all other sides. No two
/// blocks have a common corner.
Mesh block(float right) {
    return box({-4 - right, -3 - right, -3}, {right, 3, 3 + right});
}

Mesh turned_over(Mesh mesh) {
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

struct Found {
    WeldedMesh mesh;
    std::vector<bool> buried;

    explicit Found(const Mesh& source, const MeshObjects& objects = {})
        : mesh(weld(source, objects)) {
        std::vector<MeshEdge> edges = mesh_edges(mesh);
        const MeshParts parts = find_parts(mesh);
        turn_outwards(mesh, edges, parts);
        buried = buried_faces(mesh, edges, face_normals(mesh), parts, diagonal_of(mesh.vertices));
    }
    auto count() const { return std::ranges::count(buried, true); }
};

/// A ball of radius 1. Tests add bodies through which it passes.
Mesh ball() {
    return test::sphere(4);
}

TEST(BuriedFaces, AreThoseThatLieWithinTwoParts) {
    Mesh mesh = ball();
    const std::size_t of_ball = mesh.triangles.size();
    add(mesh, block(0.53F));
    add(mesh, block(0.22F));
    const Found found{mesh};
    ASSERT_EQ(found.buried.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = found.mesh.triangles[i];
        const float right = std::max(
            {found.mesh.vertices[t.x].x, found.mesh.vertices[t.y].x, found.mesh.vertices[t.z].x});
        EXPECT_EQ(found.buried[i], i < of_ball && right < 0.22F) << i;
    }
}

TEST(BuriedFaces, AreNoneOfWhatStandsInOneRoom) {
    Mesh mesh = ball();
    add(mesh, block(0.53F));
    EXPECT_EQ(Found{mesh}.count(), 0);
    // A block in a house. The ball does not reach out of the house.
    add(mesh, box({-5, -5, -5}, {5, 5, 5}));
    EXPECT_EQ(Found{mesh}.count(), 0);
}

TEST(BuriedFaces, AreNoneInWhatIsOpen) {
    for (const bool is_open : {false, true}) {
        Mesh mesh = ball(), other = block(0.22F);
        add(mesh, block(0.53F));
        if (is_open) other.triangles.pop_back();
        add(mesh, other);
        EXPECT_EQ(Found{mesh}.count() == 0, is_open);
    }
}

TEST(BuriedFaces, AreNoneInACavity) {
    Mesh mesh = ball();
    add(mesh, block(0.53F));
    add(mesh, block(0.22F));
    add(mesh, turned_over(box({-3.5F, -2, -2}, {-0.4F, 2, 2})));
    const Found found{mesh};
    EXPECT_GT(found.count(), 0);
    for (std::size_t i = 0; i < found.buried.size(); ++i) {
        const float left = bounds_of(found.mesh, static_cast<std::uint32_t>(i)).min.x;
        EXPECT_TRUE(!found.buried[i] || left > -0.4F);
    }
}

TEST(BuriedFaces, AreThoseOfPartsThatLookInwards) {
    Mesh mesh = ball();
    add(mesh, block(0.53F));
    add(mesh, block(0.22F));
    EXPECT_EQ(Found{turned_over(mesh)}.count(), Found{mesh}.count());
}

TEST(BuriedFaces, AreNoneInOtherObjects) {
    Mesh mesh = ball();
    const std::size_t of_ball = mesh.triangles.size();
    add(mesh, block(0.53F));
    add(mesh, block(0.22F));
    MeshObjects objects{.names = {"ball", "blocks"},
                        .triangles = std::vector<std::uint32_t>(mesh.triangles.size(), 1),
                        .polylines = {}};
    std::fill_n(objects.triangles.begin(), of_ball, 0U);
    EXPECT_EQ((Found{mesh, objects}.count()), 0);
}

} // namespace
} // namespace lineatlas
