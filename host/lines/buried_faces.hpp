#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "edges.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Per triangle whether it is buried: a line on it is not visible from anywhere, not even from the
/// inside of one part of the model, as from a room. A triangle is buried if it lies inside two
/// other closed parts of its object, and if its own part reaches out of both. A part that lies as a
/// whole inside another one may stand in a room, and a triangle in a cavity of a part is visible
/// from the cavity. Such parts bury nothing. If rounding would decide, the triangle is not buried.
/// `left_out`: triangles of whole parts that are not looked at; may be empty.
std::vector<bool> buried_faces(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                               const std::vector<glm::dvec3>& normals, const MeshParts& parts,
                               double diagonal, const std::vector<bool>& left_out = {});

} // namespace lineatlas
