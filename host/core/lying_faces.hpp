#pragma once

#include <vector>

#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Sees faces that lie on each other as one. Where a surface stands in a file twice, for its two
/// sides or by mistake, and is cut into triangles in two ways, four faces meet at an edge that two
/// meet at. If the faces of an edge lie to two sides of it, within one degree, one of each side is
/// left: of the same group as the first, if there is one. Edges of three sides and more stay what
/// they are.
void see_lying_faces_as_one(const WeldedMesh& mesh, std::vector<MeshEdge>& edges);

} // namespace lineatlas
