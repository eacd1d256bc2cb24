#pragma once

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Clips a drawing to a circle, in pixels. Lines end where they cross the circle; arcs and cubics
/// stay arcs and cubics. Areas end at a polygon of 720 corners in the circle.
void clip_to_circle(VectorDrawing& drawing, glm::dvec2 center, double radius);

} // namespace lineatlas
