#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "edges.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Per triangle whether it is buried: no line on it is seen from anywhere, not even from within one
/// part of the model, as from a room. It is buried if it lies within two other parts of its object
/// that are closed and that its own part reaches out of. A part that stands whole within another
/// one may stand in a room, and what lies in a cavity of a part is seen from there; neither is
/// buried by it. Where rounding decides, the triangle is not buried.
std::vector<bool> buried_faces(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                               const std::vector<glm::dvec3>& normals, const MeshParts& parts,
                               double diagonal);

} // namespace lineatlas
