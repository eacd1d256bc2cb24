#include "sheet_grid.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace lineatlas {
namespace {

struct AlignedView {
    std::string_view name;
    SheetCell third; ///< by third angle, from the front
};
/// ISO 5456-2; the view from behind stands on the right by either angle.
constexpr std::array aligned_views{
    AlignedView{"front", {0, 0}}, AlignedView{"top", {0, -1}},  AlignedView{"bottom", {0, 1}},
    AlignedView{"left", {-1, 0}}, AlignedView{"right", {1, 0}}, AlignedView{"back", {2, 0}},
};

const AlignedView* aligned_view(std::string_view name) {
    const auto found = std::ranges::find(aligned_views, name, &AlignedView::name);
    return found == aligned_views.end() ? nullptr : &*found;
}

SheetCell cell_of(const AlignedView& view, ProjectionAngle angle) {
    const bool mirrored = angle == ProjectionAngle::first && view.name != "back";
    return mirrored ? SheetCell{-view.third.column, -view.third.row} : view.third;
}

bool has_column(const std::vector<SheetCell>& cells, int column) {
    return std::ranges::any_of(cells, [&](const SheetCell& c) { return c.column == column; });
}

bool has_row(const std::vector<SheetCell>& cells, int row) {
    return std::ranges::any_of(cells, [&](const SheetCell& c) { return c.row == row; });
}

/// The free cell that adds the fewest columns and rows. Among equals it is the one nearest to the
/// upper right of the front, or by first angle to the upper left.
SheetCell free_cell(const std::vector<SheetCell>& taken, ProjectionAngle angle) {
    constexpr std::array columns{1, 0, -1, 2};
    constexpr std::array rows{-1, 0, 1};
    const int sign = angle == ProjectionAngle::third ? 1 : -1;
    SheetCell best;
    int least = std::numeric_limits<int>::max();
    const auto consider = [&](SheetCell cell) {
        if (std::ranges::find(taken, cell) != taken.end()) return;
        const int added = !has_column(taken, cell.column) + !has_row(taken, cell.row);
        if (added >= least) return;
        best = cell;
        least = added;
    };
    for (const int column : columns)
        for (const int row : rows) consider({sign * column, sign * row});
    const int count = static_cast<int>(taken.size());
    for (int column = 0; column <= count; ++column) consider({3 + column, 0}); // one is free
    return best;
}

/// Renumbers the used columns, or rows, from 0 on.
void close_up(std::vector<SheetCell>& cells, int SheetCell::*number) {
    std::vector<int> used;
    for (const SheetCell& cell : cells) used.push_back(cell.*number);
    std::ranges::sort(used);
    used.erase(std::ranges::unique(used).begin(), used.end());
    for (SheetCell& cell : cells)
        cell.*number = static_cast<int>(std::ranges::find(used, cell.*number) - used.begin());
}

} // namespace

bool is_pictorial(std::string_view view) {
    return aligned_view(view) == nullptr;
}

std::vector<SheetCell> sheet_cells(const std::vector<WantedCell>& views, ProjectionAngle angle) {
    std::vector<std::optional<SheetCell>> found(views.size());
    std::vector<SheetCell> taken;
    for (const bool yields : {false, true}) {
        for (std::size_t i = 0; i < views.size(); ++i) {
            const AlignedView* aligned = aligned_view(views[i].side);
            if (aligned == nullptr || views[i].yields != yields) continue;
            found[i] = cell_of(*aligned, angle);
            while (std::ranges::find(taken, *found[i]) != taken.end()) ++found[i]->column;
            taken.push_back(*found[i]);
        }
    }
    for (std::optional<SheetCell>& cell : found)
        if (!cell) taken.push_back(*(cell = free_cell(taken, angle)));
    std::vector<SheetCell> cells;
    for (const std::optional<SheetCell>& cell : found) cells.push_back(*cell);
    close_up(cells, &SheetCell::column);
    close_up(cells, &SheetCell::row);
    return cells;
}

} // namespace lineatlas
