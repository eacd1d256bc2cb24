#pragma once

#include <limits>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lineatlas {

/// The diagonal of the box around all vertices. Thresholds are shares of this size.
inline double diagonal_of(std::span<const glm::vec3> vertices) {
    if (vertices.empty()) return 0;
    glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-low};
    for (const glm::vec3& vertex : vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    return glm::distance(glm::dvec3{low}, glm::dvec3{high});
}

} // namespace lineatlas
