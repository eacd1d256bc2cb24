#include "sheet_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "core/drawing_scale.hpp"
#include "drawn_box.hpp"
#include "sheet_frame.hpp"
#include "title_block.hpp"

namespace lineatlas {
namespace {

// Millimetres of paper.
constexpr double thin = 0.25;
constexpr double letter_height = 3.5, small_height = 2.5;
constexpr double arrow_length = 3, arrow_half_width = 0.8; ///< 30 degrees, open
constexpr double line_distance = 10;                       ///< of a dimension from the view
constexpr double gap = 1, beyond = 2;                      ///< of extension lines
constexpr double above_line = 1;                           ///< of a text

/// A view as its measures see it.
struct MeasuredView {
    SheetBox box;                 ///< around its lines
    double tolerance = 0;         ///< of the box, millimetres
    bool pictorial = false;       ///< or a section, or of another scale
    glm::dvec3 right{0}, down{0}; ///< of paper, in the model; unit vectors
};

MeasuredView measured(const SheetView& view, const VectorDrawing& drawing) {
    const DrawnBox box = drawn_box(drawing);
    const bool empty = box.low.x > box.high.x;
    constexpr double of_cubics = 0.03, of_others = 1e-3; // pixels
    const auto row = [&](int i) {
        const glm::mat4& m = view.camera.view;
        return glm::dvec3{m[0][i], m[1][i], m[2][i]};
    };
    return {.box = empty ? SheetBox{view.low, view.high}
                         : SheetBox{view.corner + view.scale * box.low,
                                    view.corner + view.scale * box.high},
            .tolerance = view.scale * (box.exact ? of_others : of_cubics),
            .pictorial = view.pictorial || view.cut || !view.own_scale.empty(),
            .right = row(0),
            .down = -row(1)};
}

/// The number with the fewest digits that is within the tolerance.
double rounded(double value, double tolerance) {
    for (int digits = 0; digits < 9; ++digits) {
        const double power = std::pow(10, digits);
        const double candidate = std::round(value * power) / power;
        if (std::abs(candidate - value) <= tolerance) return candidate;
    }
    return value;
}

std::string length_text(double millimetres) {
    return fmt::format("{:.9g}", millimetres);
}

void add_arrow(SheetMarks& marks, glm::dvec2 tip, glm::dvec2 towards) {
    const glm::dvec2 across{-towards.y, towards.x};
    const glm::dvec2 back = tip - arrow_length * towards;
    marks.polyline({back + arrow_half_width * across, tip, back - arrow_half_width * across}, thin);
}

/// Adds the line of a dimension between two points, read from the first to the second, with its
/// number above it. If there is no room between the points, arrows stand beyond them, and the
/// number stands behind the second.
void add_dimension(SheetMarks& marks, glm::dvec2 from, glm::dvec2 to, const std::string& number) {
    const glm::dvec2 way = glm::normalize(to - from);
    const glm::dvec2 above{way.y, -way.x};
    const bool upward = std::abs(way.y) > std::abs(way.x);
    const double length = glm::distance(from, to), needed = text_width(number, letter_height);
    const bool arrows_fit = length >= 3 * arrow_length;
    const bool number_fits = length >= needed;
    const double out = arrows_fit ? 0 : 2 * arrow_length;
    const double behind = number_fits ? out : 2 * arrow_length + needed;
    marks.line(from - out * way, to + behind * way, thin);
    add_arrow(marks, from, arrows_fit ? -way : way);
    add_arrow(marks, to, arrows_fit ? way : -way);
    const glm::dvec2 place = number_fits ? 0.5 * (from + to) : to + 2 * arrow_length * way;
    marks.text(place + above_line * above, letter_height, number,
               number_fits ? TextAnchor::middle : TextAnchor::start, upward);
}

/// Adds the width below a view.
void add_width(SheetMarks& marks, const SheetBox& box, double millimetres) {
    const double y = box.high.y + line_distance;
    for (const double x : {box.low.x, box.high.x})
        marks.line({x, box.high.y + gap}, {x, y + beyond}, thin);
    add_dimension(marks, {box.low.x, y}, {box.high.x, y}, length_text(millimetres));
}

/// Adds the height on the left of a view.
void add_height(SheetMarks& marks, const SheetBox& box, double millimetres) {
    const double x = box.low.x - line_distance;
    for (const double y : {box.low.y, box.high.y})
        marks.line({box.low.x - gap, y}, {x - beyond, y}, thin);
    add_dimension(marks, {x, box.high.y}, {x, box.low.y}, length_text(millimetres));
}

/// The model's axis along a direction of paper.
int axis_along(glm::dvec3 direction) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
    return axis;
}

/// Adds dimensions. Returns the sizes of the model in millimetres. `scale`: millimetres of paper
/// per millimetre of the model. Flat directions have no dimension.
glm::dvec3 add_dimensions(SheetMarks& marks, const std::vector<MeasuredView>& views, double scale) {
    glm::dvec3 sizes{0};
    for (const MeasuredView& view : views) {
        if (view.pictorial) continue;
        const auto take = [&](int axis, double on_paper, auto add) {
            if (sizes[axis] > 0 || on_paper <= view.tolerance) return;
            sizes[axis] = rounded(on_paper / scale, view.tolerance / scale);
            add(marks, view.box, sizes[axis]);
        };
        take(axis_along(view.right), view.box.size().x, add_width);
        take(axis_along(view.down), view.box.size().y, add_height);
    }
    return sizes;
}

/// Adds the model's axes, below and on the left of a view.
void add_axes(SheetMarks& marks, const MeasuredView& view) {
    constexpr double length = 6, distance = 14, behind_tip = 2;
    constexpr std::array names{"X", "Y", "Z"};
    const glm::dvec2 origin{view.box.low.x - distance, view.box.high.y + distance};
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec2 way = length * glm::dvec2{view.right[axis], view.down[axis]};
        const double seen = glm::length(way);
        if (seen < 0.1 * length) continue; // along the line of sight
        const glm::dvec2 tip = origin + way;
        marks.line(origin, tip, thin);
        marks.text(tip + behind_tip * way / seen + glm::dvec2{0, 0.5 * small_height}, small_height,
                   names[static_cast<std::size_t>(axis)], TextAnchor::middle);
    }
}

/// The longest of 1, 2 and 5 times a power of ten that is no longer.
double round_length(double longest) {
    const double power = std::pow(10, std::floor(std::log10(longest)));
    for (const int step : {5, 2})
        if (step * power <= longest) return step * power;
    return power;
}

/// Adds a scale bar in the lower left corner of the frame, or above the title block if that is in
/// the way.
void add_scale_bar(SheetMarks& marks, const SheetBox& frame, double scale) {
    constexpr double tick = 2, from_left = 10, from_below = 4;
    const double longest = std::min(60.0, 0.5 * frame.size().x);
    const double length = round_length(longest / scale);
    const std::string number = length_text(length) + " mm";
    const SheetBox block = title_block_of(frame);
    const double right =
        frame.low.x + from_left + length * scale + text_width(number, small_height);
    const double below = right < block.low.x ? frame.high.y : block.low.y;
    const glm::dvec2 start{frame.low.x + from_left, below - from_below};
    const glm::dvec2 end = start + glm::dvec2{length * scale, 0};
    marks.line(start, end, 2 * thin);
    for (const glm::dvec2 place : {start, 0.5 * (start + end), end})
        marks.line(place, place - glm::dvec2{0, tick}, thin);
    const glm::dvec2 up{0, -tick - above_line};
    marks.text(start + up, small_height, "0", TextAnchor::middle);
    marks.text(end + up, small_height, number, TextAnchor::middle);
}

} // namespace

void add_measures(VectorSheet& sheet) {
    SheetLayout& layout = sheet.layout;
    const double scale = parse_scale("the scale", layout.scale);
    std::vector<MeasuredView> views;
    for (std::size_t i = 0; i < layout.views.size(); ++i)
        views.push_back(measured(layout.views[i], sheet.drawings[i]));
    SheetMarks dimensions{layout, "dimensions"};
    sheet.model_size = add_dimensions(dimensions, views, scale);
    SheetMarks axes{layout, "axes"};
    for (std::size_t i = 0; i < views.size(); ++i)
        if (!layout.views[i].detail) add_axes(axes, views[i]);
    SheetMarks bar{layout, "scale-bar"};
    add_scale_bar(bar, frame_of(layout.size), scale);
}

} // namespace lineatlas
