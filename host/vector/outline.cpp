#include "outline.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "arc_fitting.hpp"

namespace lineatlas {

namespace {

OutlinePoint begin_of(const VectorArc& arc) {
    return {.at = arc.at(arc.from),
            .bulge = arc.ratio == 1 ? std::tan(0.25 * arc.sweep) : 0,
            .arc = arc};
}

/// A loop that is one curve, by halves.
Outline whole(const VectorArc& curve) {
    VectorArc half = curve;
    half.sweep *= 0.5;
    Outline outline{.points = {begin_of(half)}, .closed = true};
    half.from += half.sweep;
    outline.points.push_back(begin_of(half));
    return outline;
}

/// A path whose curves are arcs.
Outline with_curves(const VectorPath& path) {
    const VectorCurve& first = path.curves[0];
    if (path.closed && !first.cubic && first.first == 0 && first.last + 1 == path.points.size())
        return whole(path.curves[0].arc);
    Outline outline{.points = {}, .closed = path.closed};
    auto curve = path.curves.begin();
    for (std::uint32_t i = 0; i + 1 < path.points.size();) {
        OutlinePoint point{path.points[i].at};
        if (curve != path.curves.end() && curve->first == i) {
            if (curve->cubic)
                point.cubic = curve->cubic;
            else
                point = begin_of(curve->arc);
            point.at = path.points[i].at; // where the way before it ends
            i = curve->last;
            ++curve;
        } else {
            ++i;
        }
        outline.points.push_back(point);
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

/// The integral of a smooth function from 0 to 1, by Gauss's rule of three points in each of
/// several parts.
template <class Function>
double integral(const Function& function) {
    constexpr int parts = 32;
    const double off = 0.5 * std::sqrt(0.6);
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const auto at = [&](double share) { return function((i + share) / parts); };
        sum += (5 * at(0.5 - off) + 8 * at(0.5) + 5 * at(0.5 + off)) / 18;
    }
    return sum / parts;
}

double length_of(const VectorCubic& cubic, glm::dvec2 start, glm::dvec2 end) {
    const glm::dvec2 a = cubic.first_control - start, b = cubic.last_control - cubic.first_control,
                     c = end - cubic.last_control;
    return 3 * integral([&](double t) {
               const double s = 1 - t;
               return glm::length(s * s * a + 2 * s * t * b + t * t * c);
           });
}

} // namespace

bool Outline::is_round() const {
    if (!closed || points.size() != 2) return false;
    const OutlinePoint& a = points[0];
    const OutlinePoint& b = points[1];
    if (!a.arc || !b.arc) return std::abs(a.bulge) == 1 && a.bulge == b.bulge;
    return a.arc->center == b.arc->center && a.arc->major == b.arc->major &&
           a.arc->ratio == b.arc->ratio &&
           std::abs(a.arc->sweep + b.arc->sweep) == 2 * std::numbers::pi;
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

double length_of(const VectorArc& arc) {
    const double reach = glm::length(arc.major);
    if (arc.ratio == 1) return reach * std::abs(arc.sweep);
    return std::abs(arc.sweep) * reach * integral([&](double share) {
               const double angle = arc.from + share * arc.sweep;
               return std::hypot(std::sin(angle), arc.ratio * std::cos(angle));
           });
}

double length_of(const Outline& outline) {
    const std::vector<OutlinePoint>& points = outline.points;
    const std::size_t steps = points.size() - (outline.closed || points.empty() ? 0 : 1);
    double length = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const OutlinePoint& from = points[i];
        const glm::dvec2 to = points[(i + 1) % points.size()].at;
        if (from.cubic)
            length += length_of(*from.cubic, from.at, to);
        else if (!from.is_straight())
            length += length_of(arc_between(from, to));
        else
            length += glm::distance(from.at, to);
    }
    return length;
}

std::vector<Outline> outlines_of(const VectorFill& fill, const Sheet& sheet) {
    std::vector<Outline> outlines;
    for (const std::vector<glm::dvec2>& ring : fill.rings) {
        Outline& outline = outlines.emplace_back(Outline{.points = {}, .closed = true});
        for (const glm::dvec2 point : ring) outline.points.push_back({sheet.place(point)});
    }
    return outlines;
}

Outline outline_of(const VectorPath& path, const Sheet& sheet, const ArcChoice& arcs) {
    const bool known = arcs.known && !path.curves.empty();
    Outline outline = known ? with_curves(path) : of_chords(path);
    if (!known && arcs.fitted) outline = fit_arcs(outline);
    for (OutlinePoint& point : outline.points) {
        point.at = sheet.place(point.at);
        if (point.cubic)
            point.cubic = {sheet.place(point.cubic->first_control),
                           sheet.place(point.cubic->last_control)};
        if (!point.arc) continue;
        point.arc->center = sheet.place(point.arc->center);
        point.arc->major *= sheet.scale;
    }
    return outline;
}

} // namespace lineatlas
