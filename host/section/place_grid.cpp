#include "place_grid.hpp"

#include <algorithm>
#include <bit>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace lineatlas {

PlaceGrid::PlaceGrid(const std::vector<glm::vec3>& positions, double rounding)
    : positions_(positions), rounding_(rounding), width_(std::max(8 * rounding, 1e-300)) {}

void PlaceGrid::add(std::uint32_t index) {
    cells_.emplace(cell(glm::floor(glm::dvec3{positions_[index]} / width_)), index);
}

std::size_t PlaceGrid::Hash::operator()(const Cell& cell) const {
    std::uint64_t h = 0;
    for (const std::uint64_t number : cell) {
        h = (h ^ number) * 0x9E3779B97F4A7C15ULL;
        h ^= h >> 29U;
    }
    return static_cast<std::size_t>(h);
}

PlaceGrid::Cell PlaceGrid::cell(glm::dvec3 corner) {
    corner += 0.0; // -0 becomes 0
    return {std::bit_cast<std::uint64_t>(corner.x), std::bit_cast<std::uint64_t>(corner.y),
            std::bit_cast<std::uint64_t>(corner.z)};
}

std::size_t PlaceGrid::cells_near(glm::dvec3 at, std::array<Cell, 8>& found) const {
    const glm::dvec3 low = glm::floor((at - rounding_) / width_);
    const glm::dvec3 high = glm::floor((at + rounding_) / width_);
    std::size_t count = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::bvec3 on{(corner & 1U) != 0, (corner & 2U) != 0, (corner & 4U) != 0};
        const glm::dvec3 cell_at = glm::mix(low, high, on);
        const bool repeated =
            (on.x && high.x == low.x) || (on.y && high.y == low.y) || (on.z && high.z == low.z);
        if (!repeated) found[count++] = cell(cell_at);
    }
    return count;
}

bool PlaceGrid::is_at(std::uint32_t index, glm::dvec3 at) const {
    const glm::dvec3 off = glm::abs(glm::dvec3{positions_[index]} - at);
    return std::max({off.x, off.y, off.z}) <= rounding_;
}

} // namespace lineatlas
