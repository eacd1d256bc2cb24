#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/sheet.hpp"

namespace lineatlas {

/// Letters of references on a drawing. I and O look like numbers (ISO 5457).
constexpr std::string_view reference_letters = "ABCDEFGHJKLMNPQRSTUVWXYZ";

/// A rectangle on paper, millimetres.
struct SheetBox {
    glm::dvec2 low{0}, high{0};

    glm::dvec2 size() const { return high - low; }
    bool meets(const SheetBox& other, double clearance) const;
};

/// About the width of a text with capital letters of this height, whatever the font.
double text_width(const std::string& utf8, double height);

/// Adds lines and texts of one layer to a layout.
class SheetMarks {
  public:
    SheetMarks(SheetLayout& layout, std::string layer)
        : layout_(layout), layer_(std::move(layer)) {}

    void line(glm::dvec2 from, glm::dvec2 to, double width);
    void polyline(std::vector<glm::dvec2> points, double width);
    void rectangle(const SheetBox& box, double width);
    void circle(glm::dvec2 center, double radius, double width);
    /// A chain line with one dot in the middle.
    void axis(glm::dvec2 from, glm::dvec2 to, double width);
    void text(glm::dvec2 at, double height, std::string text, TextAnchor anchor = TextAnchor::start,
              bool upward = false);
    /// A text that is made smaller, and at last cut, to be no wider than `width`.
    void fitted_text(glm::dvec2 at, double height, const std::string& text, double width);

  private:
    SheetLayout& layout_;
    std::string layer_;
};

} // namespace lineatlas
