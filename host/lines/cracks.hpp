#pragma once

#include <cstddef>
#include <vector>

#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// The widest crack between boundaries that lie on each other: 0.001 % of the model's diagonal, or
/// as much as Mesh::precision allows.
double widest_crack_of(const WeldedMesh& mesh);
/// Only boundaries at least so many times as long as a crack is wide are merged.
inline constexpr double least_lengths_of_crack = 20;

/// Makes one edge of two boundaries of a mesh that lie on each other except for rounding. Many
/// programs write each face of a body, or each patch of a surface, with corners of its own, which
/// agree to a few digits. Both ends have to meet, within widest_crack_of() the mesh, and the edge
/// must be much longer than that. The vertices are merged into the first of them, so that later
/// steps find one surface there. No vertex is removed, but triangles that lose a corner are.
/// Returns how many boundaries became one edge with another; if any, `edges` are no longer those of
/// the mesh.
std::size_t close_cracks(WeldedMesh& mesh, const std::vector<MeshEdge>& edges);

} // namespace lineatlas
