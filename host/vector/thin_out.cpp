#include "thin_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/stretches.hpp"
#include "core/path_share.hpp"
#include "paths.hpp"
#include "shared/constants.h"

namespace lineatlas {
namespace {

/// Paths are looked at in steps of this, pixels.
constexpr double step = 2;
/// Thinned parts, and parts between them, are at least this long, pixels.
constexpr double least = 12;
/// A cell of the grid, pixels a side, as of the kernel `density`.
constexpr double cell = LA_DENSITY_CELL;
/// The density that a straight line adds at its own places. Half of it counts before the line is
/// drawn, so the limit is met in the mean.
constexpr double own_density = 1 / (3 * cell);
/// Paths of this length count as long, pixels.
constexpr double long_path = 1000;

/// The length of lines drawn about each place.
class Ink {
  public:
    explicit Ink(glm::dvec2 picture)
        : size_(glm::max(glm::ivec2{glm::ceil(picture / cell)}, glm::ivec2{1})),
          lengths_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y)) {}

    void add(glm::dvec2 place, double length) { lengths_[index(cell_of(place))] += length; }

    /// Pixels of line per pixel of the picture: a tent over five cells a side.
    double density(glm::dvec2 place) const {
        constexpr std::array<double, 5> tent{1, 2, 3, 2, 1};
        const glm::ivec2 middle = cell_of(place);
        double sum = 0, weights = 0;
        for (int y = -2; y <= 2; ++y) {
            for (int x = -2; x <= 2; ++x) {
                const glm::ivec2 at = middle + glm::ivec2{x, y};
                if (at != clamped(at)) continue;
                const double weight =
                    tent[static_cast<std::size_t>(x + 2)] * tent[static_cast<std::size_t>(y + 2)];
                sum += weight * lengths_[index(at)];
                weights += weight;
            }
        }
        return sum / (weights * cell * cell);
    }

  private:
    glm::ivec2 clamped(glm::ivec2 at) const { return glm::clamp(at, glm::ivec2{0}, size_ - 1); }
    glm::ivec2 cell_of(glm::dvec2 place) const {
        return clamped(glm::ivec2{glm::floor(place / cell)});
    }
    std::size_t index(glm::ivec2 at) const {
        return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(at.x);
    }

    glm::ivec2 size_;
    std::vector<double> lengths_; ///< per cell, pixels
};

/// Calls `visit` with the middle of every step of a path, its distance from the start, and the
/// length of the step.
template <class Visit>
void walk(const VectorPath& path, const Visit& visit) {
    double passed = 0;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const glm::dvec2 a = path.points[i].at, way = path.points[i + 1].at - a;
        const double length = glm::length(way);
        const double steps = std::ceil(length / step);
        for (double k = 0; k < steps; ++k)
            visit(a + way * ((k + 0.5) / steps), passed + length * k / steps, length / steps);
        passed += length;
    }
}

double priority_of(const VectorPath& path, const Density& density) {
    const double kind{density.priority[static_cast<std::size_t>(path.kind)]};
    const double length = std::min(std::log1p(length_of(path)) / std::log1p(long_path), 1.0);
    const double chance{path_share(path.pieces.empty() ? 0 : path.pieces.front().segment)};
    return double{LA_PRIORITY_KIND} * kind + double{LA_PRIORITY_LENGTH} * length +
           double{LA_PRIORITY_CHANCE} * chance;
}

/// The order of drawing: outlines first, then by priority.
std::vector<std::size_t> drawing_order(const std::vector<VectorPath>& paths,
                                       const Density& density) {
    std::vector<double> priorities;
    for (const VectorPath& path : paths) {
        constexpr double above_all = 2;
        priorities.push_back(priority_of(path, density) + (path.outline ? above_all : 0));
    }
    std::vector<std::size_t> order(paths.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return priorities[a] > priorities[b]; });
    return order;
}

/// The parts of a path that would take the ink about them beyond `limit`.
std::vector<Stretch> dense_parts(const VectorPath& path, double limit, const Ink& ink) {
    std::vector<Stretch> parts;
    const double most = std::max(limit - own_density / 2, 0.0);
    double whole = 0;
    walk(path, [&](glm::dvec2 place, double from, double length) {
        whole = from + length;
        if (ink.density(place) > most) parts.push_back({from, whole});
    });
    join_stretches(parts, least);
    std::erase_if(parts,
                  [&](Stretch part) { return part.to - part.from < std::min(least, whole); });
    if (parts.empty()) return parts;
    if (parts.front().from < least) parts.front().from = 0;
    if (whole - parts.back().to < least) parts.back().to = whole;
    return parts;
}

bool is_in(const std::vector<Stretch>& parts, double place) {
    const auto after = std::ranges::upper_bound(parts, place, {}, &Stretch::from);
    return after != parts.begin() && place < std::prev(after)->to;
}

/// Divides a path into its parts within and between `dense`, in order.
void divide(VectorPath&& path, const std::vector<Stretch>& dense, std::vector<VectorPath>& result) {
    const double whole = length_of(path);
    if (dense.front().from <= 0 && dense.front().to >= whole) {
        path.thinned = true;
        result.push_back(std::move(path));
        return;
    }
    const auto add = [&](double from, double to, bool thinned) {
        if (!(to > from)) return;
        VectorPath part = part_of(path, from, to);
        part.thinned = thinned;
        if (part.points.size() > 1) result.push_back(std::move(part));
    };
    double from = 0;
    for (const Stretch part : dense) {
        add(from, part.from, false);
        add(part.from, part.to, true);
        from = part.to;
    }
    add(from, whole, false);
}

} // namespace

std::vector<VectorPath> thin_out(std::vector<VectorPath> paths, const Style& style,
                                 glm::dvec2 picture) {
    const auto limit_of = [&](const VectorPath& path) {
        return double{path.visible ? style.density.limit : style.hidden_density};
    };
    if (!(style.density.limit > 0) && !(style.hidden_density > 0)) return paths;
    Ink visible{picture}, hidden{picture};
    std::vector<std::vector<Stretch>> dense(paths.size());
    for (const std::size_t i : drawing_order(paths, style.density)) {
        const VectorPath& path = paths[i];
        if (!(limit_of(path) > 0)) continue;
        Ink& ink = path.visible ? visible : hidden;
        dense[i] = dense_parts(path, limit_of(path), ink);
        walk(path, [&](glm::dvec2 place, double from, double length) {
            if (!is_in(dense[i], from + 0.5 * length)) ink.add(place, length);
        });
    }
    std::vector<VectorPath> result;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (dense[i].empty())
            result.push_back(std::move(paths[i]));
        else
            divide(std::move(paths[i]), dense[i], result);
    }
    return result;
}

} // namespace lineatlas
