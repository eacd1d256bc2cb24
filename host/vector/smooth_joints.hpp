#pragma once

#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Joins silhouettes of known surfaces where two of them meet smoothly and no other path ends. A
/// silhouette that goes on in two lines, one behind the other, may have been chained to the line
/// that is not drawn. Call after remove_overlaps(), before paths have curves.
void join_smoothly(std::vector<VectorPath>& paths);

} // namespace lineatlas
