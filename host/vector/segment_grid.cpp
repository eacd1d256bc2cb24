#include "segment_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lineatlas {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr double least_cell = 2;
constexpr double most_cells_per_axis = 2048;

int cells(double pixels, double cell) {
    return std::max(1, static_cast<int>(std::ceil(pixels / cell)));
}

int cell_at(double pixels, double cell, int count) {
    const double index = std::floor(pixels / cell);
    return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
}

} // namespace

SegmentGrid::SegmentGrid(glm::dvec2 size)
    : cell_(std::max(least_cell, std::max(size.x, size.y) / most_cells_per_axis)),
      columns_(cells(size.x, cell_)), rows_(cells(size.y, cell_)),
      first_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none) {}

int SegmentGrid::column_of(double x) const {
    return cell_at(x, cell_, columns_);
}

int SegmentGrid::row_of(double y) const {
    return cell_at(y, cell_, rows_);
}

template <class Visit>
void SegmentGrid::for_cells(glm::dvec2 a, glm::dvec2 b, double reach, Visit&& visit) const {
    if (a.y > b.y) std::swap(a, b);
    const int first_row = row_of(a.y - reach);
    const int last_row = row_of(b.y + reach);
    for (int row = first_row; row <= last_row; ++row) {
        // The part of the line that this row of cells may be within reach of.
        double from = 0;
        double to = 1;
        if (b.y > a.y) {
            const double low = row == 0 ? a.y : row * cell_ - reach;
            const double high = row == rows_ - 1 ? b.y : (row + 1) * cell_ + reach;
            from = std::clamp((low - a.y) / (b.y - a.y), 0.0, 1.0);
            to = std::clamp((high - a.y) / (b.y - a.y), 0.0, 1.0);
        }
        const double x0 = a.x + (b.x - a.x) * from;
        const double x1 = a.x + (b.x - a.x) * to;
        const int last_column = column_of(std::max(x0, x1) + reach);
        for (int column = column_of(std::min(x0, x1) - reach); column <= last_column; ++column) {
            visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column));
        }
    }
}

void SegmentGrid::insert(glm::dvec2 a, glm::dvec2 b, std::uint32_t id) {
    constexpr double rounding = 1e-6;
    if (id >= seen_.size()) seen_.resize(std::max<std::size_t>(id + 1, seen_.size() * 2), 0);
    for_cells(a, b, rounding, [&](std::size_t cell) {
        entries_.push_back({.id = id, .next = first_[cell]});
        first_[cell] = static_cast<std::uint32_t>(entries_.size() - 1);
    });
}

const std::vector<std::uint32_t>& SegmentGrid::near(glm::dvec2 a, glm::dvec2 b, double reach) {
    found_.clear();
    ++query_;
    for_cells(a, b, reach, [&](std::size_t cell) {
        for (std::uint32_t e = first_[cell]; e != none; e = entries_[e].next) {
            const std::uint32_t id = entries_[e].id;
            if (seen_[id] == query_) continue;
            seen_[id] = query_;
            found_.push_back(id);
        }
    });
    return found_;
}

} // namespace lineatlas
