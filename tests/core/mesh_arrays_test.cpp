// Meshes from a program's own arrays.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "lineatlas/exact_arrays.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::test {
namespace {

// A square of two triangles, each vertex with a normal after its position; the last one is cut off.
constexpr std::array<float, 21> square{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0,
                                       1, 1, 1, 0, 0, 0, 1, 0, 1, 0};
constexpr std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};

TEST(MeshArrays, InterleavedVerticesBecomeAMesh) {
    const Mesh mesh = make_mesh({.positions = square, .stride = 6, .indices = indices});
    ASSERT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.positions[2], (glm::vec3{1, 1, 0}));
    EXPECT_EQ(mesh.triangles[1], (glm::uvec3{0, 2, 3}));
    EXPECT_TRUE(mesh.triangle_group.empty());
    const LineSet lines = extract_lines(mesh);
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 4U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_MATERIAL], 0U);
}

TEST(MeshArrays, MaterialsMakeLinesBetweenThem) {
    constexpr std::array<std::uint32_t, 2> materials{4'000'000'000, 7};
    const Mesh mesh =
        make_mesh({.positions = square, .stride = 6, .indices = indices, .materials = materials});
    EXPECT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[mesh.triangle_group[0]].material, "4000000000");
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_MATERIAL], 1U);
}

TEST(MeshArrays, WithoutIndicesVerticesComeInOrder) {
    constexpr std::array<float, 9> triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};
    const Mesh mesh = make_mesh({.positions = triangle});
    ASSERT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.triangles[0], (glm::uvec3{0, 1, 2}));
}

TEST(MeshArrays, PolylinesAreLinesOfTheirOwn) {
    Mesh mesh = make_mesh({.positions = square, .stride = 6, .indices = indices});
    add_polyline(mesh, std::array{glm::vec3{0, 0, 1}, glm::vec3{1, 0, 1}, glm::vec3{1, 1, 1}});
    EXPECT_EQ(extract_lines(mesh).kind_counts[LA_KIND_FILE], 2U);
}

TEST(MeshArrays, ArraysThatDoNotFitAreRefused) {
    constexpr std::array<std::uint32_t, 1> one{0};
    EXPECT_THROW(make_mesh({.positions = square, .stride = 2}), UsageError);
    EXPECT_THROW(make_mesh({.positions = square, .stride = 6}), UsageError);
    EXPECT_THROW(make_mesh({.positions = square, .stride = 6, .indices = one}), UsageError);
    EXPECT_THROW(
        make_mesh({.positions = square, .stride = 6, .indices = indices, .materials = one}),
        UsageError);
}

std::string said_about(const MeshArrays& arrays) {
    try {
        make_mesh(arrays);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "nothing";
}

TEST(MeshArrays, AnIndexThatNoVertexHasIsNamed) {
    constexpr std::array<std::uint32_t, 6> wild{0, 1, 2, 0, 99'999'999, 3};
    EXPECT_EQ(said_about({.positions = square, .stride = 6, .indices = wild}),
              "mesh: triangle 1 has the index 99999999, but the number of vertices in 21 floats at "
              "a stride of 6 is 4; the stride counts floats, not bytes");
    constexpr std::array<std::uint32_t, 3> last{0, 1, 4};
    EXPECT_THROW(make_mesh({.positions = square, .stride = 6, .indices = last}), UsageError);
}

TEST(MeshArrays, AStrideInBytesIsRefused) {
    EXPECT_EQ(said_about({.positions = square, .stride = 24, .indices = indices}),
              "mesh: triangle 0 has the index 1, but the number of vertices in 21 floats at a "
              "stride of 24 is 1; the stride counts floats, not bytes");
    EXPECT_EQ(
        said_about({.positions = square, .stride = 20}),
        "mesh: 21 floats at a stride of 20 end within a vertex; the stride counts floats, not "
        "bytes");
    const std::size_t wraps = std::numeric_limits<std::size_t>::max();
    EXPECT_THROW(make_mesh({.positions = square, .stride = wraps}), UsageError);
    EXPECT_THROW(make_mesh({.positions = square, .stride = wraps, .indices = indices}), UsageError);
}

// A roof of two faces, a metre wide.
constexpr std::array<std::uint32_t, 12> roof_indices{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
std::array<double, 18> roof_at(glm::dvec3 place) {
    std::array<double, 18> roof{0, 0, 0, 0.5, 0.5, 0, 1, 0, 0, 0, 0, 1, 0.5, 0.5, 1, 1, 0, 1};
    for (std::size_t i = 0; i < roof.size(); ++i) roof[i] += place[static_cast<int>(i % 3)];
    return roof;
}

TEST(ExactArrays, NearZeroTheyAreAsFloats) {
    const std::array<double, 18> roof = roof_at({3, -2, 20});
    const std::vector<float> floats{roof.begin(), roof.end()};
    const ExactMesh made = make_mesh({.positions = roof, .indices = roof_indices});
    EXPECT_EQ(made.origin, glm::dvec3{0});
    const Mesh expected = make_mesh({.positions = floats, .indices = roof_indices});
    EXPECT_EQ(made.mesh.positions, expected.positions);
    EXPECT_EQ(made.mesh.triangles, expected.triangles);
}

TEST(ExactArrays, FarFromZeroTheyKeepTheirDigits) {
    const std::array<double, 18> at_zero = roof_at({0, 0, 0});
    const Mesh expected = make_mesh({.positions = at_zero, .indices = roof_indices}).mesh;
    for (const glm::dvec3 place : {glm::dvec3{5e5, 0, 5e6}, {0, 0, -3e5}, {1e9, 1e9, 1e9}}) {
        const std::array<double, 18> far = roof_at(place);
        const ExactMesh made = make_mesh({.positions = far, .indices = roof_indices});
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(made.origin[axis] != 0, place[axis] != 0) << axis;
        ASSERT_EQ(made.mesh.positions.size(), expected.positions.size());
        for (std::size_t i = 0; i < expected.positions.size(); ++i) {
            const glm::dvec3 there = glm::dvec3{made.mesh.positions[i]} + made.origin;
            const glm::dvec3 wanted = glm::dvec3{expected.positions[i]} + place;
            EXPECT_LT(glm::length(there - wanted), 1e-6) << i;
        }
        EXPECT_EQ(extract_lines(made.mesh).kind_counts, extract_lines(expected).kind_counts);
    }
}

TEST(ExactArrays, PositionsThatNothingUsesDoNotCount) {
    std::array<double, 18> roof = roof_at({5e6, 0, 0});
    roof[15] = roof[16] = roof[17] = 1e12;
    const std::array<std::uint32_t, 6> half{0, 1, 4, 0, 4, 3};
    const ExactMesh made = make_mesh({.positions = roof, .indices = half});
    EXPECT_NEAR(made.origin.x, 5e6, 2);
}

TEST(ExactArrays, WhatDoesNotFitIsRefusedInDoubles) {
    const std::array<double, 18> roof = roof_at({0, 0, 0});
    const std::array<std::uint32_t, 3> beyond{0, 1, 6};
    try {
        make_mesh({.positions = roof, .indices = beyond});
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_NE(std::string{error.what()}.find("18 doubles"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace lineatlas::test
