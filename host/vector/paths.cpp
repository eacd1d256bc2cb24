#include "paths.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pieces.hpp"

namespace lineatlas {

VectorPath path_through(LineKind kind, bool visible, const std::vector<glm::dvec2>& points,
                        double depth) {
    VectorPath path{.kind = kind, .visible = visible, .points = {}, .pieces = {}};
    double arc = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (i > 0) {
            arc += glm::distance(points[i - 1], points[i]);
            path.pieces.push_back({.point = i - 1, .segment = i - 1});
        }
        path.points.push_back(
            {.at = points[i], .depth = depth, .world = {points[i], depth}, .arc = arc});
    }
    path.closed = points.size() > 2 && points.front() == points.back();
    return path;
}

double share_along(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 way = b - a;
    const double squared = glm::dot(way, way);
    return squared > 0 ? std::clamp(glm::dot(point - a, way) / squared, 0.0, 1.0) : 0;
}

double distance_to(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
    return glm::distance(point, a + (b - a) * share_along(point, a, b));
}

double length_of(const VectorPath& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        length += glm::distance(path.points[i - 1].at, path.points[i].at);
    }
    return length;
}

VectorPath part_of(const VectorPath& path, double from, double to) {
    VectorPath part{.kind = path.kind,
                    .visible = path.visible,
                    .closed = false,
                    .outline = path.outline,
                    .pen = path.pen,
                    .alpha = path.alpha,
                    .points = {},
                    .pieces = {}};
    double passed = 0;
    auto piece = path.pieces.begin();
    for (std::size_t i = 0; i + 1 < path.points.size() && passed < to; ++i) {
        const VectorPoint& a = path.points[i];
        const VectorPoint& b = path.points[i + 1];
        const double length = glm::distance(a.at, b.at);
        const double end = passed + length;
        const bool inside = length > 0 && end > from;
        if (inside) {
            const double share_from = std::max(0.0, (from - passed) / length);
            const double share_to = std::min(1.0, (to - passed) / length);
            if (part.points.empty()) part.points.push_back(between(a, b, share_from));
            part.points.push_back(between(a, b, share_to));
        }
        for (; piece != path.pieces.end() && piece->point == i; ++piece) {
            if (!inside) continue;
            const auto share = [&](double of_whole) {
                const double first = std::max(0.0, (from - passed) / length);
                const double last = std::min(1.0, (to - passed) / length);
                return static_cast<float>(
                    std::clamp((of_whole - first) / (last - first), 0.0, 1.0));
            };
            VectorPiece own = *piece;
            own.point = static_cast<std::uint32_t>(part.points.size() - 2);
            own.from = share(piece->from);
            own.to = share(piece->to);
            const auto over = [&](float place) { // in the part, back in the whole piece
                const double first = std::max(0.0, (from - passed) / length);
                const double last = std::min(1.0, (to - passed) / length);
                const double at = first + place * (last - first);
                const double whole = double{piece->to} - double{piece->from};
                const double along = whole > 0 ? (at - piece->from) / whole : 0;
                return glm::mix(piece->over_start, piece->over_end, static_cast<float>(along));
            };
            own.over_start = over(own.from);
            own.over_end = over(own.to);
            if (own.to > own.from) part.pieces.push_back(own);
        }
        passed = end;
    }
    return part;
}

void reverse(VectorPath& path) {
    std::ranges::reverse(path.points);
    std::ranges::reverse(path.pieces);
    for (VectorPiece& piece : path.pieces) {
        piece.point = static_cast<std::uint32_t>(path.points.size() - 2 - piece.point);
        std::swap(piece.source.from, piece.source.to);
        std::swap(piece.over_start, piece.over_end);
        piece.from = 1 - std::exchange(piece.to, 1 - piece.from);
    }
}

void rotate(VectorPath& path, std::size_t first) {
    if (first == 0 || first + 1 >= path.points.size()) return;
    const auto edges = static_cast<std::uint32_t>(path.points.size() - 1);
    const auto by = static_cast<std::uint32_t>(first);
    path.points.pop_back();
    std::rotate(path.points.begin(), path.points.begin() + by, path.points.end());
    path.points.push_back(path.points.front());
    for (VectorPiece& piece : path.pieces) piece.point = (piece.point + edges - by) % edges;
    std::ranges::stable_sort(path.pieces, {}, &VectorPiece::point);
}

void append(VectorPath& path, const VectorPath& next) {
    const auto goes_on = [](const VectorCurve& a, const VectorCurve& b) {
        return !a.cubic && !b.cubic && a.last == b.first && a.arc.center == b.arc.center &&
               a.arc.major == b.arc.major && a.arc.ratio == b.arc.ratio &&
               std::signbit(a.arc.sweep) == std::signbit(b.arc.sweep);
    };
    const auto offset = static_cast<std::uint32_t>(path.points.size() - 1);
    path.points.insert(path.points.end(), next.points.begin() + 1, next.points.end());
    for (VectorPiece piece : next.pieces) {
        piece.point += offset;
        path.pieces.push_back(piece);
    }
    for (VectorCurve curve : next.curves) {
        curve.first += offset;
        curve.last += offset;
        if (!path.curves.empty() && goes_on(path.curves.back(), curve)) {
            path.curves.back().last = curve.last;
            path.curves.back().arc.sweep += curve.arc.sweep;
        } else {
            path.curves.push_back(curve);
        }
    }
}

} // namespace lineatlas
