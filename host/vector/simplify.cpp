#include "simplify.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "paths.hpp"

namespace lineatlas {
namespace {

constexpr double shortest_path = 0.01;

/// The point between two others that is farthest from the line between them.
std::pair<std::size_t, double> farthest(const std::vector<VectorPoint>& points, std::size_t first,
                                        std::size_t last) {
    std::pair<std::size_t, double> found{first, 0};
    for (std::size_t i = first + 1; i < last; ++i) {
        const double distance = distance_to(points[i].at, points[first].at, points[last].at);
        if (distance > found.second) found = {i, distance};
    }
    return found;
}

std::vector<std::size_t> kept_points(const std::vector<VectorPoint>& points, double tolerance,
                                     std::span<const std::uint32_t> always) {
    std::vector<bool> keep(points.size(), false);
    std::vector<std::pair<std::size_t, std::size_t>> open;
    std::size_t before = 0;
    for (const std::size_t point : always) {
        keep[point] = true;
        open.emplace_back(before, point);
        before = point;
    }
    open.emplace_back(before, points.size() - 1);
    keep.front() = keep.back() = true;
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        const auto [middle, distance] = farthest(points, first, last);
        if (!(distance > tolerance)) continue;
        keep[middle] = true;
        open.emplace_back(first, middle);
        open.emplace_back(middle, last);
    }
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i]) kept.push_back(i);
    }
    return kept;
}

} // namespace

void simplify(VectorPath& path, double tolerance, std::span<const std::uint32_t> always) {
    if (path.points.size() < 3) return;
    const std::vector<std::size_t> kept = kept_points(path.points, tolerance, always);
    std::size_t edge = 0;
    for (VectorPiece& piece : path.pieces) {
        while (edge + 2 < kept.size() && kept[edge + 1] <= piece.point) ++edge;
        const glm::dvec2 a = path.points[kept[edge]].at;
        const glm::dvec2 b = path.points[kept[edge + 1]].at;
        piece.from = static_cast<float>(share_along(path.points[piece.point].at, a, b));
        piece.to = static_cast<float>(share_along(path.points[piece.point + 1].at, a, b));
        piece.point = static_cast<std::uint32_t>(edge);
    }
    for (std::size_t i = 0; i < kept.size(); ++i) path.points[i] = path.points[kept[i]];
    path.points.resize(kept.size());
}

void simplify(std::vector<VectorPath>& paths, double tolerance, const PathCurves& curves) {
    for (VectorPath& path : paths) simplify(path, tolerance, curves.joints(path));
    std::erase_if(paths, [](const VectorPath& path) { return length_of(path) < shortest_path; });
}

} // namespace lineatlas
