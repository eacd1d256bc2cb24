#include "drawn_lines.hpp"

#include <glm/common.hpp>

namespace lineatlas {

DrawnLines drawn_lines(const VectorDrawing& drawing) {
    DrawnLines drawn;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible) continue;
        for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
            drawn.legs.push_back({path.points[i].at, path.points[i + 1].at});
        for (const VectorPiece& piece : path.pieces) {
            const glm::dvec2 a = path.points[piece.point].at;
            const glm::dvec2 b = path.points[(piece.point + 1) % path.points.size()].at;
            drawn.pieces.push_back({glm::mix(a, b, double{piece.from}),
                                    glm::mix(a, b, double{piece.to}), piece.segment});
        }
    }
    return drawn;
}

} // namespace lineatlas
