#pragma once

#include <vector>

#include "edges.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Reduces edges of three or more faces to edges of the two faces that are visible.
///
/// Faces that lie on each other count as one. If a file has a surface twice, for its two sides or
/// by mistake, and the two are cut into triangles in two ways, four faces meet at an edge of two.
/// If the faces of an edge lie to two sides of it, within one degree, one face of each side is
/// kept: of the same group as the first, if there is one.
///
/// Where bodies abut, the faces between them are not visible from anywhere. For an edge with three
/// or more sides in a part without borders, two sides are kept if they are the only neighbours
/// around the edge whose faces look at each other; otherwise the edge does not change. Returns the
/// edges at which bodies meet.
std::vector<std::uint32_t> see_lying_faces_as_one(const WeldedMesh& mesh, const MeshParts& parts,
                                                  std::vector<MeshEdge>& edges);

} // namespace lineatlas
