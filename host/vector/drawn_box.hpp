#pragma once

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// A box around all lines of a drawing, in pixels; empty (`low` above `high`) if there are none.
struct DrawnBox {
    glm::dvec2 low, high;
    /// Its sides touch straight lines and arcs only; false: some touch cubic curves.
    bool exact = true;
};

/// The box of a drawing, by its straight lines and arcs and not by the chords of the mesh.
DrawnBox drawn_box(const VectorDrawing& drawing);

} // namespace lineatlas
