#include "drawn_lines.hpp"

#include <glm/common.hpp>

#include "flatten.hpp"

namespace lineatlas {

DrawnLines drawn_lines(const VectorDrawing& drawing) {
    DrawnLines drawn;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible || path.kind == LineKind::centre) continue;
        std::vector<glm::dvec2> points;
        for (const VectorPoint& point : path.points) points.push_back(point.at);
        append_legs(flattened(points, path.curves), drawn.legs);
        drawn.path_ends.push_back(drawn.legs.size());
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
