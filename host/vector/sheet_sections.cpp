#include "sheet_sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

// Millimetres of paper. Lines are those of ISO 128-2, a long dash and a dot: 24, 3, 0.5 and 3 times
// their width.
constexpr double thin = 0.25, thick = 0.5;
constexpr double dash = 24 * thin, gap = 3 * thin, dot = 0.5 * thin;
constexpr double clear = 3;     ///< between the view and the thick end of the line
constexpr double overhang = 10; ///< of the line beyond the view
constexpr double shaft = 9;
constexpr double head_length = 4, head_half_width = 1.07; ///< 30 degrees, open
constexpr double letter_height = 5;
constexpr double from_shaft = 2.2, from_circle = 1, above_view = 4; ///< of letters

/// The line from a point along a unit axis. It begins and ends with a dash, and dashes are of one
/// length.
void add_chain(SheetMarks& marks, glm::dvec2 from, glm::dvec2 way, double length) {
    constexpr double between = 2 * gap + dot; // two dashes
    const double dots = std::max(0.0, std::round((length - dash) / (dash + between)));
    const double own_dash = (length - dots * between) / (dots + 1);
    const auto part = [&](double first, double last) {
        marks.line(from + first * way, from + last * way, thin);
    };
    double at = 0;
    for (int i = 0; i < static_cast<int>(dots); ++i) {
        part(at, at + own_dash);
        part(at + own_dash + gap, at + own_dash + gap + dot);
        at += own_dash + between;
    }
    part(at, length);
}

/// An arrow with its tip on the line, and the letter behind it.
void add_arrow(SheetMarks& marks, glm::dvec2 tip, glm::dvec2 sight, const std::string& letter) {
    const glm::dvec2 across{-sight.y, sight.x};
    const glm::dvec2 back = tip - head_length * sight;
    marks.line(tip, tip - shaft * sight, thick);
    marks.polyline({back + head_half_width * across, tip, back - head_half_width * across}, thick);
    const glm::dvec2 middle = tip - (shaft + from_shaft + 0.5 * letter_height) * sight;
    marks.text(middle + glm::dvec2{0, 0.5 * letter_height}, letter_height, letter,
               TextAnchor::middle);
}

/// How far the line goes on beyond the view from a place at its border, so that the arrow there and
/// its letter stand clear of the view.
double overhang_at(glm::dvec2 border, glm::dvec2 out, glm::dvec2 sight, const SheetBox& view) {
    constexpr double step = 1, least_clear = 1;
    const glm::dvec2 behind = -(shaft + from_shaft + 0.5 * letter_height) * sight;
    const glm::dvec2 half_letter{0.5 * letter_height};
    for (double length = overhang;; length += step) {
        const glm::dvec2 tip = border + length * out, middle = tip + behind;
        const SheetBox arrow{glm::min(tip, middle - half_letter),
                             glm::max(tip, middle + half_letter)};
        if (!arrow.meets(view, least_clear)) return length;
    }
}

/// The line of a plane from `first` to `last` along a unit vector. Both lie at the border of the
/// view that it cuts, in one place if that shows a flat model edge on.
void add_cutting_line(SheetMarks& marks, glm::dvec2 first, glm::dvec2 last, glm::dvec2 way,
                      glm::dvec2 sight, const SheetBox& view, const std::string& letter) {
    add_chain(marks, first - clear * way, way, glm::distance(first, last) + 2 * clear);
    const glm::dvec2 start = first - overhang_at(first, -way, sight, view) * way;
    const glm::dvec2 end = last + overhang_at(last, way, sight, view) * way;
    marks.line(first - clear * way, start, thick);
    marks.line(last + clear * way, end, thick);
    add_arrow(marks, start, sight, letter);
    add_arrow(marks, end, sight, letter);
}

/// What a line through a point has of a box that it meets, as lengths along the line.
glm::dvec2 within_box(glm::dvec2 point, glm::dvec2 way, glm::dvec2 low, glm::dvec2 high) {
    constexpr double across = 1e-9;
    glm::dvec2 part{-std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(way[axis]) < across) continue;
        const double a = (low[axis] - point[axis]) / way[axis];
        const double b = (high[axis] - point[axis]) / way[axis];
        part = {std::max(part.x, std::min(a, b)), std::min(part.y, std::max(a, b))};
    }
    return part.x <= part.y ? part : glm::dvec2{0.5 * (part.x + part.y)};
}

/// A unit vector without the rounding of one along an axis of the paper.
glm::dvec2 straightened(glm::dvec2 vector) {
    constexpr double rounding = 1e-6;
    for (int axis = 0; axis < 2; ++axis)
        if (std::abs(vector[axis]) < rounding) vector[axis] = 0;
    return glm::normalize(vector);
}

void add_section(SheetMarks& marks, const SheetSide& section, const SheetSide& shown,
                 glm::dvec2 place, double scale, glm::dvec3 center) {
    const glm::dvec3 normal = section.cut->normal;
    const glm::dvec2 toward_eye =
        straightened({glm::dot(normal, shown.right), glm::dot(normal, shown.down)});
    const bool turns = toward_eye.y > 0 || (toward_eye.y == 0 && toward_eye.x < 0);
    const glm::dvec2 along = (turns ? -1.0 : 1.0) * glm::dvec2{-toward_eye.y, toward_eye.x};
    const glm::dvec2 middle = glm::dot(section.cut->point - center, normal) * toward_eye;
    const glm::dvec2 part = within_box(middle, along, shown.low, shown.high);
    const auto on_paper = [&](glm::dvec2 point) { return place + scale * (point - shown.middle); };
    add_cutting_line(marks, on_paper(middle + part.x * along), on_paper(middle + part.y * along),
                     along, -toward_eye, {on_paper(shown.low), on_paper(shown.high)},
                     section.letter);
}

void add_title(SheetMarks& marks, const SheetView& view, std::string title) {
    marks.text({0.5 * (view.low.x + view.high.x), view.low.y - above_view}, letter_height,
               std::move(title), TextAnchor::middle);
}

} // namespace

void add_sections(SheetLayout& layout, std::span<const SheetSide> sides,
                  std::span<const glm::dvec2> places, std::span<const double> scales,
                  glm::dvec3 center) {
    SheetMarks marks{layout, "sections"};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const SheetSide& side = sides[i];
        if (side.detail) continue;
        const SheetView& view = layout.views[i];
        std::string title = view.own_scale.empty() ? "" : "(" + view.own_scale + ")";
        if (side.cut) {
            add_section(marks, side, sides[side.shown_on], places[side.shown_on],
                        scales[side.shown_on], center);
            title = side.letter + "-" + side.letter + (title.empty() ? "" : " " + title);
        }
        if (!title.empty()) add_title(marks, view, title);
    }
}

void add_details(SheetLayout& layout, std::span<const SheetSide> sides,
                 std::span<const glm::dvec2> places, std::span<const double> scales) {
    SheetMarks marks{layout, "details"};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const SheetSide& side = sides[i];
        if (!side.detail) continue;
        const SheetSide& shown = sides[side.shown_on];
        const double scale = scales[side.shown_on];
        const glm::dvec2 center = places[side.shown_on] + scale * (side.middle - shown.middle);
        const double radius = scale * side.detail->radius;
        marks.circle(center, radius, thin);
        const double out = (radius + from_circle) * std::numbers::sqrt2 / 2;
        marks.text(center + glm::dvec2{out, -out}, letter_height, side.letter);
        const SheetView& view = layout.views[i];
        const glm::dvec2 size = view.high - view.low;
        marks.circle(view.low + 0.5 * size, 0.5 * size.x, thin);
        add_title(marks, view, side.letter + " (" + view.own_scale + ")");
    }
}

} // namespace lineatlas
