#include "place_grid.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// The least power of two that is not below the value.
float next_power(float value) {
    int exponent = 0;
    const float part = std::frexp(value, &exponent);
    return std::ldexp(1.0F, part == 0.5F ? exponent - 1 : exponent);
}

} // namespace

GridCell GridCell::of(glm::vec3 place, float size) {
    constexpr float most = 1e9F;
    const auto cell = [&](float x) {
        return static_cast<std::int32_t>(std::clamp(std::floor(x / size), -most, most));
    };
    return {cell(place.x), cell(place.y), cell(place.z)};
}

std::size_t GridCellHash::operator()(const GridCell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int32_t c : {cell.x, cell.y, cell.z}) {
        hash = (hash ^ static_cast<std::uint32_t>(c)) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

void PlaceGrid::add(glm::vec3 place, float reach) {
    if (!(reach > 0)) return;
    const float size = next_power(2 * reach);
    auto level = std::ranges::find(levels_, size, &Level::size);
    if (level == levels_.end()) level = levels_.insert(level, {size});
    level->cells[GridCell::of(place, size)].push_back({place, reach});
}

bool PlaceGrid::near(glm::vec3 place) const {
    return std::ranges::any_of(levels_, [&](const Level& level) { return near(level, place); });
}

/// No place reaches farther than half a cell, so the eight cells about the nearest corner have all
/// places in question.
bool PlaceGrid::near(const Level& level, glm::vec3 place) {
    const GridCell low = GridCell::of(place - 0.5F * level.size, level.size);
    for (int i = 0; i < 8; ++i) {
        const GridCell cell{low.x + i % 2, low.y + i / 2 % 2, low.z + i / 4};
        const auto entries = level.cells.find(cell);
        if (entries == level.cells.end()) continue;
        for (const Entry& one : entries->second)
            if (glm::distance(one.place, place) <= one.reach) return true;
    }
    return false;
}

void MeanGrid::start(float size) {
    size_ = size;
    sums_.clear();
    means_.clear();
}

void MeanGrid::add(glm::vec3 place, float value, float weight) {
    Sum& sum = sums_[GridCell::of(place, size_)];
    sum.value += double{value} * weight;
    sum.weight += weight;
}

MeanGrid::Sum MeanGrid::around(const GridCell& cell) const {
    Sum all;
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
        const auto sum = sums_.find({cell.x + x, cell.y + y, cell.z + z});
        if (sum == sums_.end()) continue;
        const double weight = (x == 0 ? 1 : 0.5) * (y == 0 ? 1 : 0.5) * (z == 0 ? 1 : 0.5);
        all.value += weight * sum->second.value;
        all.weight += weight * sum->second.weight;
    }
    return all;
}

float MeanGrid::about(glm::vec3 place) {
    const GridCell cell = GridCell::of(place, size_);
    const auto [mean, is_new] = means_.try_emplace(cell, 0.0F);
    if (is_new) {
        const Sum all = around(cell);
        mean->second = all.weight > 0 ? static_cast<float>(all.value / all.weight) : 0;
    }
    return mean->second;
}

} // namespace lineatlas
