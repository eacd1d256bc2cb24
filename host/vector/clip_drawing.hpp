#pragma once

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Leaves of a drawing what lies in a circle, in pixels. Straight lines end where they cross it;
/// arcs and cubics stay what they are, between other parameters. Areas end at a polygon of 720
/// corners in the circle.
void clip_to_circle(VectorDrawing& drawing, glm::dvec2 center, double radius);

} // namespace lineatlas
