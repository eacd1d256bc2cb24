#include "outline.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "arc_fitting.hpp"

namespace lineatlas {

namespace {

/// A path whose curves are arcs.
Outline with_curves(const VectorPath& path) {
    Outline outline{.points = {}, .closed = path.closed};
    auto curve = path.curves.begin();
    for (std::uint32_t i = 0; i + 1 < path.points.size();) {
        OutlinePoint point{path.points[i].at};
        if (curve == path.curves.end() || curve->first != i) {
            outline.points.push_back(point);
            ++i;
            continue;
        }
        VectorArc arc = curve->arc;
        const bool whole =
            path.closed && curve->first == 0 && curve->last + 1 == path.points.size();
        if (whole) arc.sweep *= 0.5; // twice the half
        point.arc = arc;
        if (arc.ratio == 1) point.bulge = std::tan(0.25 * arc.sweep);
        if (whole) point.at = arc.at(arc.from);
        outline.points.push_back(point);
        if (whole) {
            point.arc->from += arc.sweep;
            point.at = arc.at(point.arc->from);
            outline.points.push_back(point);
        }
        i = curve->last;
        ++curve;
    }
    if (!path.closed) outline.points.push_back({path.points.back().at});
    return outline;
}

Outline of_chords(const VectorPath& path) {
    Outline outline{.points = {}, .closed = path.closed};
    for (const VectorPoint& point : path.points) outline.points.push_back({point.at});
    if (path.closed) outline.points.pop_back();
    return outline;
}

} // namespace

bool Outline::is_round() const {
    if (!closed || points.size() != 2) return false;
    const auto is_half = [](const OutlinePoint& point) {
        return std::abs(point.arc ? std::tan(0.25 * point.arc->sweep) : point.bulge) > 1 - 1e-12;
    };
    return is_half(points[0]) && is_half(points[1]) && points[0].bulge == points[1].bulge;
}

VectorArc arc_between(const OutlinePoint& from, glm::dvec2 to) {
    if (from.arc) return *from.arc;
    const glm::dvec2 chord = to - from.at;
    const double bulge = from.bulge;
    const glm::dvec2 across{-chord.y, chord.x};
    const glm::dvec2 center = 0.5 * (from.at + to) + across * ((1 - bulge * bulge) / (4 * bulge));
    const glm::dvec2 out = from.at - center;
    return {.center = center,
            .major = {glm::length(out), 0},
            .ratio = 1,
            .from = std::atan2(out.y, out.x),
            .sweep = 4 * std::atan(bulge)};
}

Outline outline_of(const VectorPath& path, const Sheet& sheet, const ArcChoice& arcs) {
    const bool known = arcs.known && !path.curves.empty();
    Outline outline = known ? with_curves(path) : of_chords(path);
    if (!known && arcs.fitted) outline = fit_arcs(outline);
    for (OutlinePoint& point : outline.points) {
        point.at = sheet.place(point.at);
        if (!point.arc) continue;
        point.arc->center = sheet.place(point.arc->center);
        point.arc->major *= sheet.scale;
    }
    return outline;
}

} // namespace lineatlas
