#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/sheet.hpp"

namespace lineatlas {

/// A place in the grid of a sheet's views: columns from left to right, rows from top to bottom,
/// counted from the first used ones.
struct SheetCell {
    int column = 0;
    int row = 0;
    bool operator==(const SheetCell&) const = default;
};

/// Whether a view is not aligned with others.
bool is_pictorial(std::string_view view);

/// What a view wants of the grid.
struct WantedCell {
    std::string side;    ///< from which it looks; empty: a detail or an oblique section
    bool yields = false; ///< a section: stands on the right of that side's view, if there is one
};

/// A different cell for each view. The angle of projection places aligned views. Pictorial views,
/// details and oblique sections stand where they add the fewest columns and rows.
std::vector<SheetCell> sheet_cells(const std::vector<WantedCell>& views, ProjectionAngle angle);

} // namespace lineatlas
