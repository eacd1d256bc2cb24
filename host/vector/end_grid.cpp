#include "end_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// Places per cell, about.
constexpr double crowd = 2;

} // namespace

EndGrid::EndGrid(std::vector<PathEnd> ends, std::size_t paths)
    : ends_(std::move(ends)), taken_(paths, false), left_(paths) {
    if (ends_.empty()) {
        cells_.resize(1);
        return;
    }
    glm::dvec2 high = low_ = ends_.front().at;
    for (const PathEnd& end : ends_) {
        low_ = glm::min(low_, end.at);
        high = glm::max(high, end.at);
    }
    const glm::dvec2 size = glm::max(high - low_, glm::dvec2{1});
    cell_ = std::sqrt(size.x * size.y * crowd / static_cast<double>(ends_.size()));
    // A long thin set must not get more cells than places.
    cell_ = std::max(cell_, std::max(size.x, size.y) / static_cast<double>(ends_.size()));
    count_ = glm::ivec2{glm::floor(size / cell_)} + 1;
    cells_.resize(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y));
    for (std::uint32_t i = 0; i < ends_.size(); ++i) {
        const glm::ivec2 cell = cell_of(ends_[i].at);
        cells_[static_cast<std::size_t>(cell.y * count_.x + cell.x)].ends.push_back(i);
    }
}

glm::ivec2 EndGrid::cell_of(glm::dvec2 at) const {
    const glm::dvec2 last{count_ - 1};
    return glm::ivec2{glm::clamp(glm::floor((at - low_) / cell_), glm::dvec2{0}, last)};
}

void EndGrid::take(std::uint32_t path) {
    if (taken_[path]) return;
    taken_[path] = true;
    --left_;
}

void EndGrid::search_cell(glm::ivec2 cell, glm::dvec2 at, std::optional<PathEnd>& best,
                          double& best_distance) {
    std::vector<std::uint32_t>& ends =
        cells_[static_cast<std::size_t>(cell.y * count_.x + cell.x)].ends;
    // Ends of taken paths are never needed again.
    std::erase_if(ends, [&](std::uint32_t i) { return taken_[ends_[i].path]; });
    for (const std::uint32_t i : ends) {
        const double distance = glm::distance(ends_[i].at, at);
        if (distance < best_distance) {
            best_distance = distance;
            best = ends_[i];
        }
    }
}

void EndGrid::search_ring(glm::ivec2 centre, int radius, glm::dvec2 at,
                          std::optional<PathEnd>& best, double& best_distance) {
    const glm::ivec2 low = glm::max(centre - radius, glm::ivec2{0});
    const glm::ivec2 high = glm::min(centre + radius, count_ - 1);
    for (int y = low.y; y <= high.y; ++y) {
        const bool border = std::abs(y - centre.y) == radius;
        const int step = border || radius == 0 ? 1 : 2 * radius;
        for (int x = border ? low.x : centre.x - radius; x <= high.x; x += step) {
            if (x >= low.x) search_cell({x, y}, at, best, best_distance);
        }
    }
}

std::optional<PathEnd> EndGrid::nearest(glm::dvec2 at) {
    std::optional<PathEnd> best;
    if (left_ == 0) return best;
    double best_distance = std::numeric_limits<double>::infinity();
    const glm::ivec2 centre = cell_of(at);
    const int most = std::max(count_.x, count_.y);
    for (int radius = 0; radius <= most; ++radius) {
        // Nothing in this ring of cells is nearer than the rings within are wide.
        if (best && best_distance <= (radius - 1) * cell_) break;
        search_ring(centre, radius, at, best, best_distance);
    }
    return best;
}

} // namespace lineatlas
