#pragma once

#include <vector>

#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"
#include "pieces.hpp"

namespace lineatlas {

/// Joins pieces to polylines. Pieces of a path join at its vertices; silhouettes, each a path of
/// its own in the line set, at the mesh's vertices, the straightest first. Only pieces of one kind
/// that are all visible or all hidden are joined.
std::vector<VectorPath> chain_pieces(const LineSet& lines, const Pieces& pieces);

} // namespace lineatlas
