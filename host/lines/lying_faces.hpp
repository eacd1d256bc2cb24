#pragma once

#include <vector>

#include "edges.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Sees edges of three faces and more as the edges of two that they look like.
///
/// Faces that lie on each other are one. Where a surface stands in a file twice, for its two
/// sides or by mistake, and is cut into triangles in two ways, four faces meet at an edge that two
/// meet at. If the faces of an edge lie to two sides of it, within one degree, one of each side is
/// left: of the same group as the first, if there is one.
///
/// Where bodies abut, the faces between them are seen from nowhere. Of an edge in a part without
/// borders, of three sides and more, two sides are left if they are the only neighbours around it
/// whose faces look at each other; else it stays what it is. Gives the edges that bodies meet at.
std::vector<std::uint32_t> see_lying_faces_as_one(const WeldedMesh& mesh, const MeshParts& parts,
                                                  std::vector<MeshEdge>& edges);

} // namespace lineatlas
