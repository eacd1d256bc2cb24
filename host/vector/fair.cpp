#include "fair.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

constexpr int rounds = 20;
constexpr double most_shift = 0.25; ///< pixels

bool is_rough(const LineSet& lines, const VectorPath& path) {
    return !path.pieces.empty() && std::ranges::all_of(path.pieces, [&](const VectorPiece& piece) {
        return (lines.segments[piece.segment].tag & LA_TAG_UNDESIGNED) != 0;
    });
}

/// The place on the way from one neighbour to the other at the share of the way that the point has.
glm::dvec2 between(glm::dvec2 before, glm::dvec2 point, glm::dvec2 after) {
    const double from = glm::distance(before, point), to = glm::distance(point, after);
    return from + to > 0 ? (before * to + after * from) / (from + to) : point;
}

glm::dvec2 near_to(glm::dvec2 given, glm::dvec2 wanted) {
    const double shift = glm::distance(given, wanted);
    return shift > most_shift ? given + (wanted - given) * (most_shift / shift) : wanted;
}

void fair(VectorPath& path) {
    const std::vector<VectorPoint> given = path.points;
    for (int round = 0; round < rounds; ++round) {
        glm::dvec2 before = path.points.front().at;
        for (std::size_t i = 1; i + 1 < given.size(); ++i) {
            glm::dvec2& at = path.points[i].at;
            const glm::dvec2 wanted = 0.5 * (at + between(before, at, path.points[i + 1].at));
            before = at;
            at = near_to(given[i].at, wanted);
        }
    }
}

} // namespace

void fair(const LineSet& lines, std::vector<VectorPath>& paths) {
    for (VectorPath& path : paths)
        if (path.points.size() > 2 && is_rough(lines, path)) fair(path);
}

} // namespace lineatlas
