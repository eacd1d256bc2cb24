#include "point_grid.hpp"

#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lineatlas {

PointGrid::PointGrid(std::vector<glm::vec2> points, glm::ivec2 picture)
    : cells_(picture / static_cast<int>(most_reach) + 3),
      first_(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) + 1),
      points_(points.size()) {
    const auto index = [&](glm::vec2 at) {
        const glm::ivec2 c = cell(glm::dvec2{at});
        return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(cells_.x) +
               static_cast<std::size_t>(c.x);
    };
    for (const glm::vec2& point : points) ++first_[index(point) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
    for (const glm::vec2& point : points) points_[place[index(point)]++] = point;
}

glm::ivec2 PointGrid::cell(glm::dvec2 at) const {
    return glm::ivec2{
        glm::clamp(glm::floor(at / most_reach) + 1.0, glm::dvec2{0}, glm::dvec2{cells_ - 1})};
}

bool PointGrid::any_within(glm::dvec2 at, double reach) const {
    const glm::ivec2 low = glm::max(cell(at) - 1, glm::ivec2{0});
    const glm::ivec2 high = glm::min(cell(at) + 1, cells_ - 1);
    for (int y = low.y; y <= high.y; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_.x);
        const std::uint32_t begin = first_[row + static_cast<std::size_t>(low.x)];
        const std::uint32_t end = first_[row + static_cast<std::size_t>(high.x) + 1];
        for (std::uint32_t i = begin; i < end; ++i)
            if (glm::distance(glm::dvec2{points_[i]}, at) <= reach) return true;
    }
    return false;
}

} // namespace lineatlas
