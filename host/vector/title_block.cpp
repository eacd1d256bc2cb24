#include "title_block.hpp"

#include <algorithm>

namespace lineatlas {
namespace {

// Millimetres of a block with the width of ISO 7200.
constexpr double full_width = 180, full_height = 32;
constexpr double outer_width = 0.5, inner_width = 0.25;
constexpr double label_height = 1.8, value_height = 2.5, title_height = 5;

/// A block that may be narrower. Converts places from a block of the full width.
class Block {
  public:
    Block(SheetLayout& layout, const SheetBox& box)
        : marks_(layout, "title-block"), box_(box), share_(box.size().x / full_width) {}

    glm::dvec2 at(glm::dvec2 place) const { return box_.low + share_ * place; }

    void outline() { marks_.rectangle(box_, outer_width); }

    /// A field with its name in small letters. An empty field is left to be filled by hand.
    void field(const SheetBox& box, const std::string& name, const std::string& value,
               double height = value_height) {
        marks_.rectangle({at(box.low), at(box.high)}, inner_width);
        constexpr double indent = 1.5;
        marks_.text(at(box.low + glm::dvec2{indent, 1.2 + label_height}), share_ * label_height,
                    name);
        const double room = box.size().x - 2 * indent;
        marks_.fitted_text(at({box.low.x + indent, box.high.y - 1.5}), share_ * height, value,
                           share_ * room);
    }

    /// The truncated cone of ISO 5456-2 about a point, its narrow end on the left, as seen from
    /// the side and from its left, which stands on the left by third angle.
    void symbol(glm::dvec2 middle, ProjectionAngle angle) {
        constexpr double small = 2.25, large = 4.5; // radii
        constexpr double apart = 8, half_length = 5, beyond = 1.5;
        const double left = angle == ProjectionAngle::third ? -1 : 1;
        const glm::dvec2 rings = middle + glm::dvec2{left * apart, 0};
        const glm::dvec2 cone = middle - glm::dvec2{left * apart, 0};
        for (const double radius : {small, large})
            marks_.circle(at(rings), share_ * radius, outer_width);
        const auto corner = [&](double x, double y) { return at(cone + glm::dvec2{x, y}); };
        marks_.polyline({corner(-half_length, -small), corner(half_length, -large),
                         corner(half_length, large), corner(-half_length, small),
                         corner(-half_length, -small)},
                        outer_width);
        const double reach = large + beyond;
        marks_.axis(at(rings - glm::dvec2{reach, 0}), at(rings + glm::dvec2{reach, 0}),
                    inner_width);
        marks_.axis(at(rings - glm::dvec2{0, reach}), at(rings + glm::dvec2{0, reach}),
                    inner_width);
        marks_.axis(corner(-half_length - beyond, 0), corner(half_length + beyond, 0), inner_width);
    }

  private:
    SheetMarks marks_;
    SheetBox box_;
    double share_;
};

} // namespace

SheetBox title_block_of(const SheetBox& frame) {
    const double width = std::min(full_width, frame.size().x);
    const glm::dvec2 size = width / full_width * glm::dvec2{full_width, full_height};
    return {frame.high - size, frame.high};
}

void add_title_block(SheetLayout& layout, const SheetBox& box, const SheetFields& fields,
                     const TitleBlockFacts& facts) {
    Block block{layout, box};
    block.field({{0, 0}, {70, 8}}, "Owner", fields.owner);
    block.field({{70, 0}, {110, 8}}, "Drawn by", fields.creator);
    block.field({{110, 0}, {150, 8}}, "Approved by", fields.approver);
    block.field({{150, 0}, {180, 8}}, "Date", fields.date);
    block.field({{0, 8}, {110, 24}}, "Title", fields.title, title_height);
    block.field({{110, 8}, {150, 24}}, "", "");
    block.symbol({130, 16}, facts.angle);
    block.field({{150, 8}, {180, 24}}, "Scale", facts.scale, title_height);
    block.field({{0, 24}, {70, 32}}, "File", fields.file);
    block.field({{70, 24}, {150, 32}}, "Number", fields.number);
    block.field({{150, 24}, {180, 32}}, "Format", facts.page);
    block.outline();
}

} // namespace lineatlas
