#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/surface.hpp"

namespace lineatlas {

/// The ellipse by whose turning a surface of revolution is made, as a torus is, in the half plane
/// from the axis towards `out`. None if the turned curve is no ellipse, or is not in one plane with
/// the axis.
std::optional<SurfaceCurve> meridian_ellipse(const SurfaceShape& shape, glm::dvec3 out);

/// The circle or ellipse in which a plane cuts a surface of revolution, near the place with the
/// parameters `at`. A cylinder, cone or sphere may be cut in any direction, any other surface
/// across the axis or along it. `plain` is plain_shape() of the shape. None if the cut is another
/// curve, or if the surface is scaled differently along its axes.
std::optional<SurfaceCurve> plane_section(const SurfaceShape& shape, const SurfaceShape& plain,
                                          const PlacedSurface& placed, glm::dvec3 point,
                                          glm::dvec3 normal, glm::dvec2 at);

/// Whether a plane cuts a surface in straight lines: a plane, a cylinder along its axis, or a cone
/// through it. `plain` is plain_shape() of the surface's shape.
bool is_cut_straight(const SurfaceShape& plain, const PlacedSurface& placed, glm::dvec3 point,
                     glm::dvec3 normal);

/// A place of a surface on a plane, near the place with the parameters `at`. None if the surface
/// only touches the plane there.
std::optional<glm::dvec3> place_on_plane(const SurfaceShape& shape, const PlacedSurface& placed,
                                         glm::dvec3 point, glm::dvec3 normal, glm::dvec2 at);

/// The place where a line goes through a surface, near the place with the parameters `at`. None if
/// the line only touches the surface there.
std::optional<glm::dvec3> place_on_line(const SurfaceShape& shape, const PlacedSurface& placed,
                                        glm::dvec3 from, glm::dvec3 way, glm::dvec2 at);

/// The place of two surfaces on a plane, near the places with the parameters `at` and `other_at`.
/// None if the plane cuts both in curves that only touch there.
std::optional<glm::dvec3> place_on_both(const SurfaceShape& shape, const PlacedSurface& placed,
                                        glm::dvec2 at, const SurfaceShape& other,
                                        const PlacedSurface& other_placed, glm::dvec2 other_at,
                                        glm::dvec3 point, glm::dvec3 normal);

} // namespace lineatlas
