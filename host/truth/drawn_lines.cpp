#include "drawn_lines.hpp"

#include <glm/common.hpp>

#include "flatten.hpp"

namespace lineatlas {

void DrawnLines::add_legs(std::span<const glm::dvec2> points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) legs.push_back({points[i], points[i + 1]});
}

DrawnLines drawn_lines(const VectorDrawing& drawing) {
    DrawnLines drawn;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible) continue;
        std::vector<glm::dvec2> points;
        for (const VectorPoint& point : path.points) points.push_back(point.at);
        drawn.add_legs(flattened(points, path.curves));
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
