#pragma once

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// A box around all lines of a drawing, in pixels; empty (`low` above `high`) where there are none.
struct DrawnBox {
    glm::dvec2 low, high;
    bool exact = true; ///< its sides touch straight lines and arcs; else cubic curves, too
};

/// Straight lines and arcs are taken as they are, not by the chords of the mesh.
DrawnBox drawn_box(const VectorDrawing& drawing);

} // namespace lineatlas
