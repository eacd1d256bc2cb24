#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// A vector in the coordinates in which the curve is the unit circle.
inline glm::dvec2 unrolled(const EdgeCurve& curve, glm::dvec3 way) {
    return {glm::dot(way, curve.u) / glm::dot(curve.u, curve.u),
            glm::dot(way, curve.v) / glm::dot(curve.v, curve.v)};
}

/// The angle of the curve in whose direction from the centre a place lies.
inline double angle_on(const EdgeCurve& curve, glm::dvec3 place) {
    const glm::dvec2 out = unrolled(curve, place - curve.center);
    return std::atan2(out.y, out.x);
}

inline glm::dvec3 place_on(const EdgeCurve& curve, double angle) {
    return curve.center + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
}

} // namespace lineatlas
