#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "shared/meshlet_table.h"

namespace lineatlas {

/// Clusters with lists of their own vertices, as the kernels of `depth` draw them.
struct Meshlets {
    std::vector<Meshlet> meshlets; ///< one per cluster
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint8_t> corners;
};

/// `triangles`: in the order that `clusters` are pieces of, each of LA_MESHLET_TRIANGLES at most;
/// `vertex_count`: of the table that they refer to.
Meshlets build_meshlets(std::span<const glm::uvec3> triangles, std::span<const Cluster> clusters,
                        std::size_t vertex_count);

} // namespace lineatlas
