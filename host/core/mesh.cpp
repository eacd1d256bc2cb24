#include "lineatlas/mesh.hpp"

#include <glm/common.hpp>

#include "check_mesh.hpp"

namespace lineatlas {

Bounds bounds_of(const Mesh& mesh) {
    check_indices(mesh);
    Bounds bounds;
    const auto include = [&](std::uint32_t index) {
        bounds.min = glm::min(bounds.min, mesh.positions[index]);
        bounds.max = glm::max(bounds.max, mesh.positions[index]);
    };
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) include(triangle[corner]);
    }
    for (const auto& polyline : mesh.polylines) {
        for (const std::uint32_t index : polyline) include(index);
    }
    return bounds;
}

} // namespace lineatlas
