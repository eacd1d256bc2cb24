#include "sheet_marks.hpp"

#include <algorithm>
#include <utility>

#include "xml_text.hpp"

namespace lineatlas {
namespace {

/// The average width of a letter, in heights of capitals.
constexpr double letter_width = 0.85;

std::size_t letters(const std::string& utf8) {
    return static_cast<std::size_t>(
        std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The first letters of a text, with dots for the rest if there is any.
std::string first_letters(const std::string& utf8, std::size_t count) {
    if (letters(utf8) <= count) return utf8;
    const std::string dots = "...";
    std::size_t end = 0, seen = 0;
    while (end < utf8.size() && seen + dots.size() < count + 1) {
        ++end;
        while (end < utf8.size() && (utf8[end] & 0xC0) == 0x80) ++end;
        ++seen;
    }
    return utf8.substr(0, end) + dots;
}

} // namespace

double text_width(const std::string& utf8, double height) {
    return static_cast<double>(letters(utf8)) * letter_width * height;
}

bool SheetBox::meets(const SheetBox& other, double clearance) const {
    return low.x < other.high.x + clearance && other.low.x < high.x + clearance &&
           low.y < other.high.y + clearance && other.low.y < high.y + clearance;
}

void SheetMarks::line(glm::dvec2 from, glm::dvec2 to, double width) {
    polyline({from, to}, width);
}

void SheetMarks::polyline(std::vector<glm::dvec2> points, double width) {
    layout_.lines.push_back({.layer = layer_, .width = width, .points = std::move(points)});
}

void SheetMarks::rectangle(const SheetBox& box, double width) {
    polyline({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}, box.low}, width);
}

void SheetMarks::circle(glm::dvec2 center, double radius, double width) {
    layout_.circles.push_back(
        {.layer = layer_, .width = width, .center = center, .radius = radius});
}

void SheetMarks::axis(glm::dvec2 from, glm::dvec2 to, double width) {
    const auto part = [&](double first, double last) {
        line(from + first * (to - from), from + last * (to - from), width);
    };
    part(0, 0.42);
    part(0.48, 0.52);
    part(0.58, 1);
}

void SheetMarks::text(glm::dvec2 at, double height, std::string text, TextAnchor anchor,
                      bool upward) {
    if (text.empty()) return;
    layout_.texts.push_back({.layer = layer_,
                             .at = at,
                             .height = height,
                             .text = std::move(text),
                             .anchor = anchor,
                             .upward = upward});
}

void SheetMarks::fitted_text(glm::dvec2 at, double height, const std::string& text, double width) {
    const std::string clean = xml_text(text);
    constexpr double least_height = 1.8; // ISO 3098
    const auto count = static_cast<double>(std::max<std::size_t>(letters(clean), 1));
    const double fitting =
        std::clamp(width / (count * letter_width), std::min(least_height, height), height);
    this->text(at, fitting,
               first_letters(clean, static_cast<std::size_t>(width / (fitting * letter_width))));
}

} // namespace lineatlas
