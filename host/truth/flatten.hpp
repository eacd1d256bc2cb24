#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

// Curves of drawings as chords that are off by at most a few thousandths of a pixel.
namespace lineatlas {

/// Adds the points of a cubic Bézier curve from `from` to `to`, without the first.
void append_cubic(glm::dvec2 from, const VectorCubic& cubic, glm::dvec2 to,
                  std::vector<glm::dvec2>& points);

/// The number of chords of an arc. `radius`: the longer one.
int chords_of_arc(double radius, double sweep);

/// The path through `points` with its curves as chords; see VectorPath. Curves that are not in
/// order or name missing points are left out.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec2> points,
                                  std::span<const VectorCurve> curves);

} // namespace lineatlas
