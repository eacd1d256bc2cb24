#include "clusters.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/common.hpp>

namespace lineatlas {
namespace {

/// Spreads the low 10 bits of x: two zeros between each.
std::uint32_t spread_bits(std::uint32_t x) {
    x = (x | x << 16U) & 0x030000FFU;
    x = (x | x << 8U) & 0x0300F00FU;
    x = (x | x << 4U) & 0x030C30C3U;
    return (x | x << 2U) & 0x09249249U;
}

/// Place along the Morton curve of a point in the unit cube.
std::uint32_t morton_code(glm::vec3 point) {
    const glm::uvec3 cell{glm::clamp(point * 1024.0F, 0.0F, 1023.0F)};
    return spread_bits(cell.x) | spread_bits(cell.y) << 1U | spread_bits(cell.z) << 2U;
}

} // namespace

TriangleClusters build_clusters(std::span<const glm::vec3> vertices,
                                std::span<const glm::uvec3> triangles, std::uint32_t cluster_size) {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};
    for (const glm::vec3& vertex : vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    const glm::vec3 extent = glm::max(high - low, std::numeric_limits<float>::min());

    std::vector<std::pair<std::uint32_t, std::uint32_t>> order(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const glm::uvec3 t = triangles[i];
        const glm::vec3 center =
            (vertices[t.x] - low + (vertices[t.y] - low) + (vertices[t.z] - low)) * (1.0F / 3);
        order[i] = {morton_code(center / extent), i};
    }
    std::ranges::sort(order);

    TriangleClusters result;
    result.triangles.reserve(triangles.size());
    for (const auto& [code, index] : order) {
        if (result.triangles.size() % cluster_size == 0) {
            const auto first = static_cast<std::uint32_t>(result.triangles.size());
            constexpr float infinity = std::numeric_limits<float>::infinity();
            result.clusters.push_back({.low = {infinity, infinity, infinity},
                                       .high = {-infinity, -infinity, -infinity},
                                       .first = first,
                                       .count = 0});
        }
        Cluster& cluster = result.clusters.back();
        ++cluster.count;
        const glm::uvec3 t = triangles[index];
        result.triangles.push_back(t);
        for (int corner = 0; corner < 3; ++corner) {
            for (int axis = 0; axis < 3; ++axis) {
                const float value = vertices[t[corner]][axis];
                cluster.low[axis] = std::min(cluster.low[axis], value);
                cluster.high[axis] = std::max(cluster.high[axis], value);
            }
        }
    }
    return result;
}

} // namespace lineatlas
