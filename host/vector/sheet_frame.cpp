#include "sheet_frame.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

// ISO 5457, millimetres.
constexpr double filing_margin = 20; ///< on the left
constexpr double margin = 10;        ///< on the other sides
constexpr double border = 5;         ///< of the grid of references, outside of the frame
constexpr double centring_mark = 5;  ///< how far it goes into the frame
constexpr double field = 50;         ///< of the grid
constexpr double frame_width = 0.7, grid_width = 0.35;
constexpr double letter_height = 3.5;
/// On pages up to this width, that of A4, the grid is only above and on the right.
constexpr double narrow_page = 216;

/// "A" to "Z" without I and O, then "AA".
std::string row_name(int row) {
    constexpr std::string_view letters = reference_letters;
    std::string name;
    for (auto at = static_cast<std::size_t>(row) + 1; at > 0; at = (at - 1) / letters.size())
        name.push_back(letters[(at - 1) % letters.size()]);
    std::ranges::reverse(name);
    return name;
}

/// The places where fields of the grid begin and end along a side. They are counted from the
/// middle, and fields at the corners get the rest.
std::vector<double> grid_lines(double side, double first, double last) {
    const int half = std::max(1, static_cast<int>(std::lround(0.5 * side / field)));
    std::vector<double> lines{first};
    for (int i = 1 - half; i < half; ++i) lines.push_back(0.5 * side + i * field);
    lines.push_back(last);
    return lines;
}

class Grid {
  public:
    Grid(SheetMarks& marks, const SheetBox& frame) : marks_(marks), frame_(frame) {}

    /// Adds fields along a horizontal side. `outward`: y from the frame to the grid's border.
    void add_columns(const std::vector<double>& lines, double y, double outward) {
        for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
            if (i > 0) marks_.line({lines[i], y}, {lines[i], y + outward}, grid_width);
            marks_.text({0.5 * (lines[i] + lines[i + 1]), y + 0.5 * outward + 0.5 * letter_height},
                        letter_height, std::to_string(i + 1), TextAnchor::middle);
        }
    }

    void add_rows(const std::vector<double>& lines, double x, double outward) {
        for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
            if (i > 0) marks_.line({x, lines[i]}, {x + outward, lines[i]}, grid_width);
            marks_.text({x + 0.5 * outward, 0.5 * (lines[i] + lines[i + 1] + letter_height)},
                        letter_height, row_name(static_cast<int>(i)), TextAnchor::middle);
        }
    }

    void add(glm::dvec2 page) {
        const std::vector<double> columns = grid_lines(page.x, frame_.low.x, frame_.high.x);
        const std::vector<double> rows = grid_lines(page.y, frame_.low.y, frame_.high.y);
        marks_.rectangle({frame_.low - border, frame_.high + border}, grid_width);
        add_columns(columns, frame_.low.y, -border);
        add_rows(rows, frame_.high.x, border);
        if (std::min(page.x, page.y) <= narrow_page) return;
        add_columns(columns, frame_.high.y, border);
        add_rows(rows, frame_.low.x, -border);
    }

  private:
    SheetMarks& marks_;
    SheetBox frame_;
};

void add_centring_marks(SheetMarks& marks, glm::dvec2 page, const SheetBox& frame) {
    const glm::dvec2 middle = 0.5 * page;
    const double inward = centring_mark, outward = border;
    marks.line({middle.x, frame.low.y - outward}, {middle.x, frame.low.y + inward}, frame_width);
    marks.line({middle.x, frame.high.y + outward}, {middle.x, frame.high.y - inward}, frame_width);
    marks.line({frame.low.x - outward, middle.y}, {frame.low.x + inward, middle.y}, frame_width);
    marks.line({frame.high.x + outward, middle.y}, {frame.high.x - inward, middle.y}, frame_width);
}

} // namespace

SheetBox frame_of(glm::dvec2 page) {
    constexpr double least_side = 60; // of what is within the frame
    const SheetBox frame{{filing_margin, margin}, page - margin};
    if (!(std::min(frame.size().x, frame.size().y) >= least_side))
        throw UsageError(
            "the page is too small for a sheet with a frame; a6 is the smallest of the "
            "named ones");
    return frame;
}

void add_frame(SheetLayout& layout) {
    SheetMarks marks{layout, "frame"};
    const SheetBox frame = frame_of(layout.size);
    marks.rectangle(frame, frame_width);
    add_centring_marks(marks, layout.size, frame);
    Grid{marks, frame}.add(layout.size);
}

} // namespace lineatlas
