#pragma once

#include <vector>

#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Moves points of silhouettes on surfaces that nobody designed to where the path bends less, by a
/// quarter of a pixel at most: what they bend from triangle to triangle is roughness. Ends stay.
void fair(const LineSet& lines, std::vector<VectorPath>& paths);

} // namespace lineatlas
