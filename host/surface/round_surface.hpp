#pragma once

#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/surface.hpp"

namespace lineatlas {

/// The plane, cylinder, cone, sphere, torus or other surface of revolution that a spline or an
/// extrusion stands for; files exchanged as NURBS have such splines. Any other shape is returned as
/// it is. The ends of the surface are lost.
SurfaceShape plain_shape(const SurfaceShape& shape);

/// Below this cosine or sine to the axis a view is meant to be level or along it: cameras hold
/// directions as floats.
constexpr double rounding_of_views = 1e-6;

/// The way from the axis of a revolution to a place, at right angles to the axis.
inline glm::dvec3 way_from_axis(const SurfaceShape& shape, glm::dvec3 place) {
    const glm::dvec3 out = place - shape.point;
    return out - glm::dot(out, shape.axis) * shape.axis;
}

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
