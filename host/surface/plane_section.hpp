#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/surface.hpp"

namespace lineatlas {

/// The ellipse that a revolution turns, as a torus does, in the half plane of the axis and a way
/// out from it: an ellipse. None where the curve is no ellipse, or not in a plane with the axis.
std::optional<SurfaceCurve> meridian_ellipse(const SurfaceShape& shape, glm::dvec3 out);

/// The circle or ellipse in which a plane cuts a surface of revolution near the place of two
/// parameters: cylinders, cones and spheres where they are cut so, and others across the axis or
/// along it. `plain` is plain_shape() of the shape. None of any other curve, or where the surface
/// is placed with another scale along another axis.
std::optional<SurfaceCurve> plane_section(const SurfaceShape& shape, const SurfaceShape& plain,
                                          const PlacedSurface& placed, glm::dvec3 point,
                                          glm::dvec3 normal, glm::dvec2 at);

} // namespace lineatlas
