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
    /// Of a mark a triangle that lies square to the axis; of an axis LA_NO_FACE.
    std::uint32_t face = LA_NO_FACE;
    bool is_turned = false; ///< its front looks from the mark along the axis, not away from it
};

/// The axes of round surfaces and, at both of their ends, marks (docs/lines.md has the rules).
/// Surfaces of different objects have axes of their own. `shapes`: those of the surfaces, plain
/// (plain_shape()). `objects`: per triangle; empty: all are of one.
std::vector<CentreLine>
find_centre_lines(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                  const std::vector<glm::dvec3>& normals, const KnownSurfaces& surfaces,
                  std::span<const SurfaceShape> shapes, std::span<const std::uint32_t> objects);

} // namespace lineatlas
