#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "curves.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Leaves out points that lie within `tolerance` pixels of the line without them (Douglas and
/// Peucker 1973). Points in `kept`, which is ascending, stay. Pieces keep their origin.
void simplify(VectorPath& path, double tolerance, std::span<const std::uint32_t> kept = {});

/// Simplifies all paths, except at joints of curves, and drops paths shorter than a hundredth of a
/// pixel.
void simplify(std::vector<VectorPath>& paths, double tolerance, const PathCurves& curves);

} // namespace lineatlas
