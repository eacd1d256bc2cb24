#pragma once

#include <glm/geometric.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas::test {

/// The volume that triangles enclose; negative where they are inside out.
inline double volume(const Mesh& mesh) {
    double sum = 0;
    for (const glm::uvec3 t : mesh.triangles)
        sum +=
            glm::dot(glm::dvec3{mesh.positions[t.x]},
                     glm::cross(glm::dvec3{mesh.positions[t.y]}, glm::dvec3{mesh.positions[t.z]})) /
            6;
    return sum;
}

} // namespace lineatlas::test
