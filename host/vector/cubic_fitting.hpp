#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// A cubic from one point to another.
struct FittedCubic {
    std::uint32_t first = 0, last = 0;
    VectorCubic cubic;
};

/// Cubic Bézier curves along a smooth line, in a row with straight parts left out. `points` are
/// points of the line. Cubics begin and end at points, with one tangent on either side. They are
/// within `most_off` pixels of all other points and within a tenth of a pixel of the chords. They
/// end at corners. closed: the last point is the first, and the line goes on there. Least squares
/// (Schneider, "An Algorithm for Automatically Fitting Digitized Curves", 1990), with tangents
/// known beforehand.
std::vector<FittedCubic> fit_cubics(std::span<const glm::dvec2> points, bool closed,
                                    double most_off);

} // namespace lineatlas
