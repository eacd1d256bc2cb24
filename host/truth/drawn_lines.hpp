#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drawing_errors.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// The visible lines of a drawing as paths, in pixels.
struct DrawnLines {
    std::vector<DrawnPiece> legs;   ///< all that is drawn, from point to point, of unknown segments
    std::vector<DrawnPiece> pieces; ///< the same by segment; empty where the drawing has no tags
    std::vector<std::size_t> path_ends{}; ///< per path, one past its last one of `legs`
};

/// Adds the legs from each point to the next.
inline void append_legs(std::span<const glm::dvec2> points, std::vector<DrawnPiece>& legs) {
    for (std::size_t i = 1; i < points.size(); ++i) legs.push_back({points[i - 1], points[i]});
}

DrawnLines drawn_lines(const VectorDrawing& drawing);

} // namespace lineatlas
