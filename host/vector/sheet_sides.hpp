#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/sheet.hpp"

namespace lineatlas {

/// A view as it looks at the model. Lengths are in units of the model, from its middle, y down.
struct SheetSide {
    std::string name;
    std::string side; ///< from which it looks: name, or that of a section
    std::string letter{};
    bool pictorial = false;
    ViewDirection direction{};
    glm::dvec3 right{0}, down{0}; ///< of paper, in the model
    glm::dvec2 low{0}, high{0};   ///< its box on paper
    glm::dvec2 middle{0};         ///< the point in the middle of its cell
    std::optional<SectionPlane> cut{};
    std::size_t cut_on = 0; ///< of a section: the side that shows its plane as a line

    /// How far it reaches from the middle of its cell.
    glm::dvec2 reach() const;
};

/// The plane of a view such as "section:x=12", as it is written; nothing if the view is no section.
std::optional<std::string_view> section_of(std::string_view view);

/// The views of options, as they look at these points. Throws UsageError for a section that misses
/// the points or that no other view shows as a line, and for more sections than letters.
std::vector<SheetSide> sheet_sides(std::span<const glm::vec3> points, const Bounds& bounds,
                                   const SheetOptions& options);

} // namespace lineatlas
