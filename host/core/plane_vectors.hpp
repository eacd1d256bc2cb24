#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lineatlas {

/// The area of the parallelogram of two vectors; above 0 if `b` lies to the left of `a`, where y
/// points up.
inline double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// From one direction to the other the shorter way round, -180 to 180 degrees, in radians.
inline double angle_between(glm::dvec2 a, glm::dvec2 b) {
    return std::atan2(cross(a, b), glm::dot(a, b));
}

} // namespace lineatlas
