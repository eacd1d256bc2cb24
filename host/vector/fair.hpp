#pragma once

#include <vector>

#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Moves points of silhouettes on undesigned surfaces to where the path bends less, by a quarter of
/// a pixel at most. Bends from triangle to triangle are only roughness there. Ends stay.
void fair(const LineSet& lines, std::vector<VectorPath>& paths);

} // namespace lineatlas
