#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/surface.hpp"

namespace lineatlas {

/// A point of a surface, with the derivatives that silhouettes need.
struct SurfacePoint {
    glm::dvec3 at{0};
    glm::dvec3 u{0}, v{0};               ///< derivative of the point by each parameter
    glm::dvec3 normal{0};                ///< along du x dv, of length 1; 0 at a pole or a tip
    glm::dvec3 normal_u{0}, normal_v{0}; ///< derivative of the normal by each parameter
};

/// Evaluates a sound shape (is_sound()). Beyond the ends of its parameters the shape goes on. `u`
/// and `v` are right for offset surfaces too.
SurfacePoint evaluate(const SurfaceShape& shape, glm::dvec2 parameters);

} // namespace lineatlas
