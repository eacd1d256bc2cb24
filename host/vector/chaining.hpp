#pragma once

#include <vector>

#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"
#include "pieces.hpp"
#include "strips.hpp"

namespace lineatlas {

/// A polyline for every stroke of every strip; one that goes on across the seam of a closed strip
/// is one polyline, closed if it goes all around.
std::vector<VectorPath> chain_strips(const LineSet& lines, const Pieces& pieces,
                                     const std::vector<Strip>& strips);

} // namespace lineatlas
