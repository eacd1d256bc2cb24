#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "edges.hpp"
#include "lineatlas/surface.hpp"
#include "weld.hpp"

namespace lineatlas {

/// An axis, or one of the two lines of its mark.
struct CentreLine {
    glm::vec3 p, q;
    std::uint32_t vertex; ///< of its surface
    std::uint32_t source; ///< of its surface, index into Mesh::triangles
    /// For a mark a triangle that lies square to the axis; for an axis LA_NO_FACE.
    std::uint32_t face = LA_NO_FACE;
    /// The front of that triangle looks from the mark towards the body, not away from it.
    bool is_turned = false;
};

/// Finds the axes of round surfaces, and marks at both ends of the axes (docs/lines.md has the
/// rules). Surfaces of different objects have axes of their own. `shapes`: plain_shape() of each
/// surface. `objects`: the object of each triangle; empty: all are of one.
std::vector<CentreLine>
find_centre_lines(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                  const std::vector<glm::dvec3>& normals, const KnownSurfaces& surfaces,
                  std::span<const SurfaceShape> shapes, std::span<const std::uint32_t> objects);

} // namespace lineatlas
