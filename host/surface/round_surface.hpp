#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "lineatlas/surface.hpp"

namespace lineatlas {

/// The plane, cylinder, cone, sphere, torus or other surface of revolution that a spline or an
/// extrusion stands for; files exchanged as NURBS have such splines. Any other shape is returned as
/// it is. The ends of the surface are lost.
SurfaceShape plain_shape(const SurfaceShape& shape);

/// The line that a round surface turns about.
struct AxisLine {
    glm::dvec3 point{0};
    glm::dvec3 direction{0}; ///< of length 1
};

/// The axis of a plain surface of revolution. None for a plane or a sphere, which have no single
/// one.
std::optional<AxisLine> axis_of(const SurfaceShape& shape, const PlacedSurface& placed);

/// Whether a place lies on a plain plane, cylinder, cone, sphere or torus, beyond its ends too, to
/// a tolerance above 0. False for any other surface.
bool holds_place(const SurfaceShape& shape, const PlacedSurface& placed, glm::dvec3 place,
                 double tolerance);

} // namespace lineatlas
