#pragma once

#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// A circle on the screen, pixels.
struct Circle {
    glm::dvec2 center;
    double radius;

    /// Distance of a point from the circle: below 0 within it.
    double beyond(glm::dvec2 at) const { return glm::distance(at, center) - radius; }
    /// Distances below this one are rounding.
    double rounding() const { return 1e-9 * radius; }
};

/// The point of a cubic from `start` to `end` at a share of it.
glm::dvec2 point_of(const VectorCubic& cubic, glm::dvec2 start, glm::dvec2 end, double share);

/// The angles at which an arc crosses a circle, in the order of its sweep, however close they are.
/// Angles at which the arc touches the circle may be among them.
std::vector<double> crossings(const VectorArc& arc, const Circle& circle);

/// The same for a cubic from `start` to `end`: shares of it.
std::vector<double> crossings(const VectorCubic& cubic, glm::dvec2 start, glm::dvec2 end,
                              const Circle& circle);

} // namespace lineatlas
