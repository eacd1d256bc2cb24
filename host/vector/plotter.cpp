#include "plotter.hpp"

#include <algorithm>
#include <span>

#include <glm/geometric.hpp>

#include "end_grid.hpp"
#include "paths.hpp"

namespace lineatlas {
namespace {

/// The longest part of the order that is turned round, in paths, and the number of rounds in which
/// all parts are tried.
constexpr std::size_t longest_stretch = 128;
constexpr int most_rounds = 6;
/// Closed paths may start at any of their points. At most about so many of these are tried.
constexpr std::size_t most_starts = 64;

double travel_of(std::span<const VectorPath> paths) {
    double travel = 0;
    for (std::size_t i = 1; i < paths.size(); ++i) {
        travel += glm::distance(paths[i - 1].points.back().at, paths[i].points.front().at);
    }
    return travel;
}

std::vector<PathEnd> ends_of(std::span<const VectorPath> paths) {
    std::vector<PathEnd> ends;
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        const std::vector<VectorPoint>& points = paths[i].points;
        const std::size_t last = points.size() - 1;
        const std::size_t step = paths[i].closed ? 1 + last / most_starts : last;
        for (std::size_t k = 0; k <= last; k += step) {
            ends.push_back({points[k].at, i, static_cast<std::uint32_t>(k)});
        }
    }
    return ends;
}

/// Orders paths by always going on to the nearest end. `at`: where the pen is.
void order_greedily(std::span<VectorPath> paths, glm::dvec2 at) {
    EndGrid grid{ends_of(paths), paths.size()};
    std::vector<VectorPath> ordered;
    ordered.reserve(paths.size());
    while (const std::optional<PathEnd> next = grid.nearest(at)) {
        grid.take(next->path);
        VectorPath& path = paths[next->path];
        if (path.closed) {
            rotate(path, next->point);
        } else if (next->point != 0) {
            reverse(path);
        }
        at = path.points.back().at;
        ordered.push_back(std::move(path));
    }
    std::ranges::move(ordered, paths.begin());
}

/// Two ends of a path in the tour, or of a part of it.
struct Stop {
    glm::dvec2 start, end;
    std::uint32_t path;
    bool reversed;
};

double squared(glm::dvec2 way) {
    return glm::dot(way, way);
}

/// The length that is saved by turning the part from i to j round. `before`: where the pen comes
/// from.
double gain_of(const std::vector<Stop>& tour, glm::dvec2 before, std::size_t i, std::size_t j) {
    const glm::dvec2 start = tour[i].start;
    const glm::dvec2 end = tour[j].end;
    const double at_start = glm::distance(before, start) - glm::distance(before, end);
    if (j + 1 == tour.size()) return at_start;
    const glm::dvec2 after = tour[j + 1].start;
    return at_start + glm::distance(end, after) - glm::distance(start, after);
}

/// A cheap test whether one of the two ways would become shorter. If none would, nothing is saved.
bool may_gain(const std::vector<Stop>& tour, glm::dvec2 before, std::size_t i, std::size_t j) {
    const glm::dvec2 start = tour[i].start;
    const glm::dvec2 end = tour[j].end;
    if (squared(end - before) < squared(start - before)) return true;
    if (j + 1 == tour.size()) return false;
    const glm::dvec2 after = tour[j + 1].start;
    return squared(after - start) < squared(after - end);
}

void turn(std::vector<Stop>& tour, std::size_t i, std::size_t j) {
    const std::span<Stop> turned{tour.data() + i, j + 1 - i};
    std::ranges::reverse(turned);
    for (Stop& stop : turned) {
        std::swap(stop.start, stop.end);
        stop.reversed = !stop.reversed;
    }
}

/// Turns parts of the tour round where that shortens it (2-opt).
bool turn_parts(std::vector<Stop>& tour, glm::dvec2 at) {
    constexpr double rounding = 1e-6; // pixels
    bool shorter = false;
    for (std::size_t i = 0; i < tour.size(); ++i) {
        const glm::dvec2 before = i > 0 ? tour[i - 1].end : at;
        const std::size_t last = std::min(tour.size(), i + longest_stretch);
        for (std::size_t j = i; j < last; ++j) {
            if (!may_gain(tour, before, i, j) || !(gain_of(tour, before, i, j) > rounding)) {
                continue;
            }
            turn(tour, i, j);
            shorter = true;
        }
    }
    return shorter;
}

void improve(std::span<VectorPath> paths, glm::dvec2 at) {
    std::vector<Stop> tour;
    tour.reserve(paths.size());
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        tour.push_back({paths[i].points.front().at, paths[i].points.back().at, i, false});
    }
    for (int round = 0; round < most_rounds && turn_parts(tour, at); ++round) {
    }
    std::vector<VectorPath> ordered;
    ordered.reserve(paths.size());
    for (const Stop& stop : tour) {
        ordered.push_back(std::move(paths[stop.path]));
        if (stop.reversed) reverse(ordered.back());
    }
    std::ranges::move(ordered, paths.begin());
}

/// Adds a straight line between two ends. The ends stay at their places, because lines that move
/// even by so little may come to lie along others.
void bridge(VectorPath& path, const VectorPoint& to) {
    VectorPiece piece = path.pieces.back();
    piece.point = static_cast<std::uint32_t>(path.points.size() - 1);
    piece.from = 0;
    piece.to = 1;
    path.pieces.push_back(piece);
    path.points.push_back(to);
}

/// Lets `path` go on in `next`.
void join(VectorPath& path, VectorPath&& next) {
    const double length = length_of(path);
    const double next_length = length_of(next);
    const double sum = std::max(length + next_length, 1e-9);
    path.alpha = static_cast<float>(
        (static_cast<double>(path.alpha) * length + static_cast<double>(next.alpha) * next_length) /
        sum);
    if (next.points.front().at != path.points.back().at) bridge(path, next.points.front());
    append(path, next);
}

bool same_group(const VectorPath& a, const VectorPath& b) {
    return a.kind == b.kind && a.visible == b.visible;
}

/// Joins neighbours in the order whose ends meet.
std::vector<VectorPath> join_all(std::vector<VectorPath> paths, double gap) {
    std::vector<VectorPath> joined;
    for (VectorPath& path : paths) {
        const bool meets =
            !joined.empty() && same_group(joined.back(), path) && !joined.back().closed &&
            !path.closed &&
            glm::distance(joined.back().points.back().at, path.points.front().at) <= gap;
        if (meets) {
            join(joined.back(), std::move(path));
        } else {
            joined.push_back(std::move(path));
        }
    }
    return joined;
}

/// Closes a path that comes back to its start. Machines that cut treat it as one contour.
void close(VectorPath& path, double gap) {
    const glm::dvec2 start = path.points.front().at, end = path.points.back().at;
    constexpr std::size_t fewest_points = 4;
    if (path.closed || path.points.size() < fewest_points || glm::distance(start, end) > gap ||
        length_of(path) < 4 * gap)
        return;
    if (start != end) bridge(path, path.points.front());
    path.closed = true;
}

} // namespace

PenTravel order_for_plotter(std::vector<VectorPath>& paths, double gap) {
    PenTravel travel{.before = travel_of(paths), .paths_before = paths.size()};
    glm::dvec2 at{0, 0};
    for (auto first = paths.begin(); first != paths.end();) {
        const auto last = std::find_if_not(
            first, paths.end(), [&](const VectorPath& path) { return same_group(*first, path); });
        const std::span<VectorPath> group{first, last};
        order_greedily(group, at);
        improve(group, at);
        at = group.back().points.back().at;
        first = last;
    }
    paths = join_all(std::move(paths), gap);
    for (VectorPath& path : paths) close(path, gap);
    travel.after = travel_of(paths);
    travel.paths_after = paths.size();
    return travel;
}

} // namespace lineatlas
