#include "core/clusters.hpp"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "test_meshes.hpp"

namespace lineatlas {
namespace {

std::vector<glm::uvec3> sorted(std::vector<glm::uvec3> triangles) {
    std::ranges::sort(triangles, {}, [](glm::uvec3 t) { return std::tuple{t.x, t.y, t.z}; });
    return triangles;
}

TEST(BuildClusters, HoldEveryTriangleOnceInsideTheirBoxes) {
    const Mesh mesh = test::sphere(4);
    for (const std::uint32_t size : {1U, 7U, 128U, 100'000U}) {
        const TriangleClusters parts = build_clusters(mesh.positions, mesh.triangles, size);
        EXPECT_EQ(sorted(parts.triangles), sorted(mesh.triangles));
        ASSERT_EQ(parts.order.size(), parts.triangles.size());
        for (std::size_t i = 0; i < parts.order.size(); ++i) {
            ASSERT_EQ(parts.triangles[i], mesh.triangles[parts.order[i]]);
        }
        std::uint32_t next = 0;
        for (const Cluster& cluster : parts.clusters) {
            EXPECT_EQ(cluster.first, next);
            EXPECT_GE(cluster.count, 1U);
            EXPECT_LE(cluster.count, size);
            next += cluster.count;
            for (std::uint32_t i = cluster.first; i < next; ++i) {
                for (int corner = 0; corner < 3; ++corner) {
                    const glm::vec3 p = mesh.positions[parts.triangles[i][corner]];
                    for (int axis = 0; axis < 3; ++axis) {
                        ASSERT_GE(p[axis], cluster.low[axis]);
                        ASSERT_LE(p[axis], cluster.high[axis]);
                    }
                }
            }
        }
        EXPECT_EQ(next, mesh.triangles.size());
    }
}

TEST(BuildClusters, AreSmallInSpace) {
    const Mesh mesh = test::sphere(6);
    const TriangleClusters parts = build_clusters(mesh.positions, mesh.triangles, 64);
    float summed = 0;
    for (const Cluster& c : parts.clusters) {
        summed += (c.high[0] - c.low[0]) * (c.high[1] - c.low[1]) * (c.high[2] - c.low[2]);
    }
    EXPECT_LT(summed, 0.5F * 8) << "the boxes together should be much less than the sphere's box";
}

TEST(BuildClusters, OfNothingAreNone) {
    EXPECT_TRUE(build_clusters({}, {}, 128).clusters.empty());
    EXPECT_TRUE(build_clusters({}, {}, 128).triangles.empty());
}

} // namespace
} // namespace lineatlas
