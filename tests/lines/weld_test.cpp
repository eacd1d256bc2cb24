#include "lines/weld.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/objects.hpp"
#include "lineatlas/error.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

std::array<float, 3> key_of(glm::vec3 p) {
    return {p.x, p.y, p.z};
}

TEST(Weld, MergesTheCornersOfASoup) {
    const WeldedMesh welded = weld(test::with_own_corners(test::cube()));
    EXPECT_EQ(welded.vertices.size(), 8U);
    EXPECT_EQ(welded.triangles.size(), 12U);
    EXPECT_EQ(welded.triangle_group, std::vector<std::uint32_t>(12, 0));
}

TEST(Weld, KeepsEveryTriangleWhereItWas) {
    test::Random random{1};
    const Mesh mesh = test::with_own_corners(test::height_field(random, 12, 1));
    const WeldedMesh welded = weld(mesh);
    ASSERT_EQ(welded.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(welded.vertices.size(), 13U * 13U);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            EXPECT_EQ(welded.vertices[welded.triangles[i][corner]],
                      mesh.positions[mesh.triangles[i][corner]]);
        }
    }
}

TEST(Weld, ComparesPositionsExactly) {
    const float next = std::nextafter(1.0F, 2.0F);
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {next, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {5, 3, 4}};
    const WeldedMesh welded = weld(mesh);
    EXPECT_EQ(welded.vertices.size(), 5U);
    EXPECT_NE(welded.triangles[0].y, welded.triangles[1].y);
    EXPECT_EQ(welded.triangles[0].z, welded.triangles[1].z);
}

TEST(Weld, TakesMinusZeroForZero) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 1, -0.0F}, {1, -0.0F, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(weld(mesh).vertices.size(), 4U);
}

TEST(Weld, DropsTrianglesThatLoseACorner) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    mesh.triangles = {{0, 0, 1}, {0, 1, 3}, {0, 1, 2}, {2, 1, 2}, {1, 1, 1}};
    const WeldedMesh welded = weld(mesh);
    ASSERT_EQ(welded.triangles.size(), 1U);
    EXPECT_EQ(welded.triangle_group.size(), 1U);
}

TEST(Weld, KeepsTheFirstOfTrianglesOverTheSameVertices) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {1, 3, 2}, {2, 3, 1}, {0, 2, 1}};
    mesh.triangle_group = {4, 0, 1, 3, 2, 2};
    mesh.groups.resize(5);
    const WeldedMesh welded = weld(mesh);
    ASSERT_EQ(welded.triangles.size(), 2U);
    EXPECT_EQ(welded.triangles[0], glm::uvec3(0, 1, 2));
    EXPECT_EQ(welded.triangle_group, (std::vector<std::uint32_t>{4, 3}));
}

TEST(Weld, GroupsStayWithTheirTriangles) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 0, 1}, {0, 1, 2}, {2, 1, 0}, {1, 3, 2}};
    mesh.triangle_group = {1, 2, 0, 3};
    mesh.groups.resize(4);
    EXPECT_EQ(weld(mesh).triangle_group, (std::vector<std::uint32_t>{2, 3}));
}

TEST(Weld, PolylinesLoseRepeatedNeighboursOnly) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}};
    mesh.polylines = {{0, 1, 2, 3, 3, 4}, {1, 2}, {3}, {}, {0, 1, 0}};
    const WeldedMesh welded = weld(mesh);
    ASSERT_EQ(welded.polylines.size(), 2U);
    const auto& first = welded.polylines[0];
    ASSERT_EQ(first.size(), 4U);
    EXPECT_EQ(first[0], first[3]); // it comes back to its start
    EXPECT_EQ(welded.polylines[1].size(), 3U);
}

TEST(Weld, PolylinesShareVerticesWithTriangles) {
    Mesh mesh = test::with_own_corners(test::tetrahedron());
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[0]);
    mesh.positions.emplace_back(7, 7, 7);
    mesh.polylines = {{first, first + 1}};
    const WeldedMesh welded = weld(mesh);
    EXPECT_EQ(welded.vertices.size(), 5U);
    EXPECT_EQ(welded.polylines.at(0).at(0), welded.triangles[0].x);
}

TEST(Weld, APositionIsAVertexOfEachObjectThatUsesIt) {
    Mesh mesh = test::cube();
    const std::vector<glm::uvec3> triangles = mesh.triangles;
    constexpr std::uint32_t count = 100;
    for (std::uint32_t object = 0; object < count; ++object) {
        if (object > 0)
            mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
        mesh.triangle_object.insert(mesh.triangle_object.end(), triangles.size(), object);
    }
    mesh.triangle_group.clear();
    mesh.groups.clear();
    const WeldedMesh welded = weld(mesh, find_objects(mesh));
    EXPECT_EQ(welded.vertices.size(), 8U * count);
    EXPECT_EQ(welded.triangles.size(), 12U * count);
}

TEST(Weld, AnEmptyMeshGivesAnEmptyMesh) {
    const WeldedMesh welded = weld(Mesh{});
    EXPECT_TRUE(welded.vertices.empty());
    EXPECT_TRUE(welded.triangles.empty());
    EXPECT_TRUE(welded.polylines.empty());
}

TEST(Weld, RefusesIndicesOutOfRange) {
    Mesh mesh = test::tetrahedron();
    mesh.triangles.emplace_back(0, 1, 4);
    EXPECT_THROW(weld(mesh), UsageError);
    mesh.triangles.back() = {0, 1, std::numeric_limits<std::uint32_t>::max()};
    EXPECT_THROW(weld(mesh), UsageError);
    mesh.triangles.pop_back();
    mesh.polylines = {{0, 1}, {3, 4}};
    EXPECT_THROW(weld(mesh), UsageError);
    mesh.polylines = {{4}};
    EXPECT_THROW(weld(mesh), UsageError);
}

TEST(Weld, RefusesPositionsThatAreNotFinite) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            Mesh mesh = test::tetrahedron();
            mesh.positions[2][axis] = bad;
            EXPECT_THROW(weld(mesh), UsageError) << bad << " on axis " << axis;
        }
    }
    Mesh opposed = test::tetrahedron();
    opposed.positions[1] = {infinity, -infinity, 0};
    EXPECT_THROW(weld(opposed), UsageError);
}

TEST(Weld, TakesAnyFinitePosition) {
    constexpr float largest = std::numeric_limits<float>::max();
    Mesh mesh = test::tetrahedron();
    mesh.positions[0] = {largest, largest, largest};
    mesh.positions[1] = {-largest, -largest, 0};
    mesh.positions[2] = {std::numeric_limits<float>::denorm_min(), 0, 0};
    mesh.positions[3] = {0, 0, 0};
    WeldedMesh welded;
    ASSERT_NO_THROW(welded = weld(mesh));
    EXPECT_EQ(welded.vertices.size(), 4U);
}

/// Positions on a coarse grid, so that many are equal, compared with sorted containers.
TEST(Weld, AgreesWithSortedContainersOnRandomSoups) {
    test::Random random{2};
    for (int round = 0; round < 40; ++round) {
        Mesh mesh = test::random_soup(random, 60, 120);
        for (glm::vec3& p : mesh.positions) {
            for (int axis = 0; axis < 3; ++axis) {
                p[axis] = std::round(p[axis] * 1.5F); // -0 among them
            }
        }
        const WeldedMesh welded = weld(mesh);

        std::set<std::array<float, 3>> vertices;
        for (const glm::vec3& v : welded.vertices) {
            EXPECT_TRUE(vertices.insert(key_of(v)).second) << "a vertex stands twice";
        }
        std::map<std::set<std::array<float, 3>>, std::size_t> expected;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            std::set<std::array<float, 3>> corners;
            for (int corner = 0; corner < 3; ++corner) {
                corners.insert(key_of(mesh.positions[mesh.triangles[i][corner]]));
            }
            if (corners.size() == 3) expected.try_emplace(corners, i);
        }
        std::map<std::set<std::array<float, 3>>, std::size_t> found;
        for (std::size_t i = 0; i < welded.triangles.size(); ++i) {
            std::set<std::array<float, 3>> corners;
            for (int corner = 0; corner < 3; ++corner) {
                corners.insert(key_of(welded.vertices[welded.triangles[i][corner]]));
            }
            EXPECT_EQ(corners.size(), 3U);
            EXPECT_TRUE(found.try_emplace(corners, i).second) << "a triangle stands twice";
        }
        ASSERT_EQ(found.size(), expected.size());
        for (const auto& entry : expected) EXPECT_TRUE(found.contains(entry.first));
    }
}

} // namespace
} // namespace lineatlas
