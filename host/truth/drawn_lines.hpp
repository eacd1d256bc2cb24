#pragma once

#include <span>
#include <vector>

#include "drawing_errors.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// The visible lines of a drawing as paths, in pixels.
struct DrawnLines {
    std::vector<DrawnPiece> legs;   ///< all that is drawn, from point to point, of unknown segments
    std::vector<DrawnPiece> pieces; ///< the same by segment; empty where the drawing has no tags

    void add_legs(std::span<const glm::dvec2> points); ///< from each to the next
};

DrawnLines drawn_lines(const VectorDrawing& drawing);

} // namespace lineatlas
