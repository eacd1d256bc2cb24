// The volume that triangles enclose.
#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "lineatlas/volume.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

/// A box from `low` on, each of its triangles with corners of its own.
Mesh loose_box(glm::vec3 low, glm::vec3 size) {
    constexpr int sides[12][3] = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                                  {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    Mesh mesh;
    for (const auto& side : sides) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const int corner : side)
            mesh.positions.push_back(low +
                                     size * glm::vec3{corner >> 2, corner >> 1 & 1, corner & 1});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

TEST(Volume, OfABoxIsItsSidesMultiplied) {
    const Mesh box = loose_box({1e4F, 0, -3}, {2, 3, 5});
    ASSERT_TRUE(enclosed_volume(box));
    EXPECT_NEAR(*enclosed_volume(box), 30, 1e-9);
}

TEST(Volume, OfABoxInsideOutIsNegative) {
    Mesh box = loose_box({0, 0, 0}, {1, 1, 1});
    for (glm::uvec3& triangle : box.triangles) std::swap(triangle.y, triangle.z);
    EXPECT_NEAR(*enclosed_volume(box), -1, 1e-9);
}

TEST(Volume, OfAnOpenMeshIsUnknown) {
    Mesh box = loose_box({0, 0, 0}, {1, 1, 1});
    std::swap(box.triangles[3].y, box.triangles[3].z); // one triangle is turned
    EXPECT_FALSE(enclosed_volume(box));
    std::swap(box.triangles[3].y, box.triangles[3].z);
    EXPECT_TRUE(enclosed_volume(box));
    box.triangles.pop_back();
    EXPECT_FALSE(enclosed_volume(box));
    EXPECT_FALSE(enclosed_volume(Mesh{}));
}

TEST(Volume, MinusZeroIsZero) {
    Mesh box = loose_box({0, 0, 0}, {1, 1, 1});
    for (std::size_t i = 0; i < box.positions.size(); i += 2)
        for (int axis = 0; axis < 3; ++axis)
            if (box.positions[i][axis] == 0) box.positions[i][axis] = -0.0F;
    EXPECT_TRUE(enclosed_volume(box));
}

TEST(Volume, OfPositionsThatAreNotThereIsRefused) {
    Mesh box = loose_box({0, 0, 0}, {1, 1, 1});
    box.triangles.back().x = 36;
    EXPECT_THROW(enclosed_volume(box), UsageError);
}

} // namespace
} // namespace lineatlas
