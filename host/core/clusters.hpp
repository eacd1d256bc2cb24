#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"
#include "segment_table.h"

namespace lineatlas {

/// Triangles in an order in which neighbours in space are neighbours in the list, cut into clusters
/// that can be drawn or left out.
struct TriangleClusters {
    std::vector<glm::uvec3> triangles;  ///< the same triangles, reordered
    std::vector<std::uint32_t> order;   ///< where each of `triangles` stood before
    std::vector<Cluster> clusters;      ///< consecutive pieces of `triangles`, with their boxes
    std::vector<std::uint32_t> objects; ///< per cluster its object; all 0 if there are no objects
};

/// Halves the triangles at medians of their centres into clusters of up to `cluster_size`, object
/// by object. Without objects all triangles count as one object.
TriangleClusters build_clusters(std::span<const glm::vec3> vertices,
                                std::span<const glm::uvec3> triangles, std::uint32_t cluster_size,
                                std::span<const LineObject> objects = {});

} // namespace lineatlas
