#pragma once

#include <vector>

#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Makes one edge of two where boundaries of a mesh lie on each other but for rounding: many
/// programs write each face of a body, or each patch of a surface, with corners of its own, which
/// agree to a few digits. Both ends have to meet, within 0.003 % of the model's diagonal or what
/// Mesh::precision allows, and the edge must be much longer than that. The vertices are merged into
/// the first of them, so that all that follows finds one surface there; none is removed. Triangles
/// that lose a corner by it are. Whether there was such an edge; `edges` are no longer those of the
/// mesh then.
bool close_cracks(WeldedMesh& mesh, const std::vector<MeshEdge>& edges);

} // namespace lineatlas
