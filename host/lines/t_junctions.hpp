#pragma once

#include <cstddef>
#include <vector>

#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Divides triangles where boundaries of a mesh lie on each other but have different corners, such
/// as one long side of a face beside two short sides of others. Afterwards each short side has an
/// edge in common with a part of the long one, and later steps find one surface there. Boundaries
/// are followed from the corners that they have in common, as long as both run along one line
/// within 0.001 % of the model's diagonal or what Mesh::precision allows. No vertex is added or
/// moved. Returns how many corners lay within another face's boundary; if any did, `edges` are no
/// longer those of the mesh.
std::size_t close_t_junctions(WeldedMesh& mesh, const std::vector<MeshEdge>& edges);

} // namespace lineatlas
