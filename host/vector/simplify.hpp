#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "curves.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Leaves out points that lie within `tolerance` pixels of the line without them (Douglas and
/// Peucker 1973), but for those that are `kept`, ascending. Pieces keep where they come from.
void simplify(VectorPath& path, double tolerance, std::span<const std::uint32_t> kept = {});

/// Simplifies all but for joints of curves, and drops those that are shorter than a hundredth of a
/// pixel.
void simplify(std::vector<VectorPath>& paths, double tolerance, const PathCurves& curves);

} // namespace lineatlas
