#pragma once

#include <span>
#include <string>

#include <glm/vec2.hpp>

#include "sheet_marks.hpp"
#include "sheet_sides.hpp"

namespace lineatlas {

/// The space that a cutting-plane line needs around its view, and letters above a section or a
/// detail.
constexpr double space_for_letters = 24;

/// Draws for each section the line of its plane on the view that it cuts, with arrows in the
/// direction of sight and its letter, and letters such as "A-A" above the section (ISO 128-3).
/// A view with a scale of its own has that above it. `places`: middles of the sides' cells in
/// millimetres. `scales`: millimetres of paper per unit of the model. `center`: the middle of the
/// model.
void add_sections(SheetLayout& layout, std::span<const SheetSide> sides,
                  std::span<const glm::dvec2> places, std::span<const double> scales,
                  glm::dvec3 center);

/// Draws for each detail its circle and letter on the view that shows it, and a circle and letters
/// such as "B (2:1)" about the detail.
void add_details(SheetLayout& layout, std::span<const SheetSide> sides,
                 std::span<const glm::dvec2> places, std::span<const double> scales);

} // namespace lineatlas
