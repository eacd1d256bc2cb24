#pragma once

#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Leaves out points that lie within `tolerance` pixels of the line without them (Douglas and
/// Peucker 1973). Pieces keep where they come from.
void simplify(VectorPath& path, double tolerance);

/// Simplifies all, and drops those that are shorter than a hundredth of a pixel.
void simplify(std::vector<VectorPath>& paths, double tolerance);

} // namespace lineatlas
