#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "lineatlas/surface.hpp"

namespace lineatlas {

/// The plane, cylinder, cone, sphere, torus or other surface of revolution that a spline or an
/// extrusion is, as exchange by NURBS makes of one; any other shape as it is. Where it ends is
/// lost.
SurfaceShape plain_shape(const SurfaceShape& shape);

/// The line that a round surface turns about.
struct AxisLine {
    glm::dvec3 point{0};
    glm::dvec3 direction{0}; ///< as long as 1
};

/// The axis of a plain surface of revolution where it has but one: none of a plane or a sphere.
std::optional<AxisLine> axis_of(const SurfaceShape& shape, const PlacedSurface& placed);

/// Whether a place lies on a plain plane, cylinder, cone, sphere or torus, wherever they end, to a
/// tolerance above 0. No other surface is known to hold a place.
bool holds_place(const SurfaceShape& shape, const PlacedSurface& placed, glm::dvec3 place,
                 double tolerance);

} // namespace lineatlas
