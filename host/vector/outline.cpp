#include "outline.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "arc_fitting.hpp"

namespace lineatlas {

bool Outline::is_circle() const {
    return closed && points.size() == 2 && std::abs(points[0].bulge) == 1 &&
           points[0].bulge == points[1].bulge;
}

Arc arc_between(const OutlinePoint& from, glm::dvec2 to) {
    const glm::dvec2 chord = to - from.at;
    const double bulge = from.bulge;
    const glm::dvec2 across{-chord.y, chord.x};
    const glm::dvec2 center = 0.5 * (from.at + to) + across * ((1 - bulge * bulge) / (4 * bulge));
    const glm::dvec2 out = from.at - center;
    return {.center = center,
            .radius = glm::length(out),
            .from = std::atan2(out.y, out.x),
            .sweep = 4 * std::atan(bulge)};
}

Outline outline_of(const VectorPath& path, const Sheet& sheet, bool with_arcs) {
    Outline outline{.points = {}, .closed = path.closed};
    for (const VectorPoint& point : path.points) outline.points.push_back({point.at});
    if (path.closed) outline.points.pop_back();
    if (with_arcs) outline = fit_arcs(outline);
    for (OutlinePoint& point : outline.points) point.at = sheet.place(point.at);
    return outline;
}

} // namespace lineatlas
