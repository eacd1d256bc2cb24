#include "point_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lineatlas {

PointGrid::PointGrid(std::span<const glm::vec2> points, glm::ivec2 picture,
                     std::span<const glm::vec2> bars)
    : cells_(picture / static_cast<int>(most_reach) + 3),
      first_(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) + 1),
      points_(points.size()), bars_(points.size(), glm::vec2{0}) {
    const auto index = [&](glm::vec2 at) {
        const glm::ivec2 c = cell(glm::dvec2{at});
        return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(cells_.x) +
               static_cast<std::size_t>(c.x);
    };
    for (const glm::vec2& point : points) ++first_[index(point) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t to = place[index(points[i])]++;
        points_[to] = points[i];
        if (!bars.empty()) bars_[to] = bars[i];
    }
}

glm::ivec2 PointGrid::cell(glm::dvec2 at) const {
    return glm::ivec2{
        glm::clamp(glm::floor(at / most_reach) + 1.0, glm::dvec2{0}, glm::dvec2{cells_ - 1})};
}

template <class Use>
bool PointGrid::any_about(glm::dvec2 at, const Use& use) const {
    const glm::ivec2 low = glm::max(cell(at) - 1, glm::ivec2{0});
    const glm::ivec2 high = glm::min(cell(at) + 1, cells_ - 1);
    for (int y = low.y; y <= high.y; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_.x);
        const std::uint32_t begin = first_[row + static_cast<std::size_t>(low.x)];
        const std::uint32_t end = first_[row + static_cast<std::size_t>(high.x) + 1];
        for (std::uint32_t i = begin; i < end; ++i)
            if (use(i)) return true;
    }
    return false;
}

bool PointGrid::any_within(glm::dvec2 at, double reach) const {
    return any_about(
        at, [&](std::uint32_t i) { return glm::distance(glm::dvec2{points_[i]}, at) <= reach; });
}

double PointGrid::distance(glm::dvec2 at, double reach) const {
    double nearest = std::numeric_limits<double>::infinity();
    any_about(at, [&](std::uint32_t i) {
        const glm::dvec2 to = at - glm::dvec2{points_[i]}, bar{bars_[i]};
        if (glm::length(to) > reach) return false;
        const double squared = glm::dot(bar, bar);
        const double share = squared > 0 ? std::clamp(glm::dot(to, bar) / squared, -1.0, 1.0) : 0;
        nearest = std::min(nearest, glm::distance(to, share * bar));
        return false;
    });
    return nearest;
}

} // namespace lineatlas
