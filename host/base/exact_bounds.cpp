#include "exact_bounds.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace lineatlas {

void ExactBounds::add_drawable(std::span<const glm::dvec3> positions,
                               std::span<const std::uint32_t> used) {
    for (const std::uint32_t index : used)
        if (is_drawable(positions[index])) add(positions[index]);
}

double ExactBounds::extent() const {
    const glm::dvec3 size = max - min;
    return std::max({size.x, size.y, size.z});
}

bool is_finite(glm::dvec3 position) {
    return std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z);
}

bool is_drawable(glm::dvec3 position) {
    const glm::dvec3 size = glm::abs(position);
    return size.x <= largest_drawable && size.y <= largest_drawable &&
           size.z <= largest_drawable; // false for NaN
}

glm::dvec3 origin_for(const ExactBounds& bounds) {
    constexpr double far = 30;
    const double extent = bounds.extent();
    glm::dvec3 origin{0};
    if (!(extent > 0)) return origin;
    const double step = std::exp2(std::ceil(std::log2(extent)));
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = 0.5 * (bounds.min[axis] + bounds.max[axis]);
        if (std::abs(middle) > far * extent) origin[axis] = std::round(middle / step) * step;
    }
    return origin;
}

std::string note_of_origin(glm::dvec3 origin) {
    return "far from zero for its size, drawn about " + written(origin);
}

std::string written(glm::dvec3 position) {
    return fmt::format("{},{},{}", position.x, position.y, position.z);
}

} // namespace lineatlas
