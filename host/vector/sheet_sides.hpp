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
    /// From which it looks: name, or that of a section; empty: a detail or an oblique section.
    std::string side;
    std::string letter{};
    bool pictorial = false;
    ViewDirection direction{};
    glm::dvec3 right{0}, down{0}; ///< of paper, in the model
    glm::dvec2 low{0}, high{0};   ///< its box on paper
    /// Box of the picture. A detail has the box of its whole view, because loops are whole before
    /// they are clipped.
    glm::dvec2 picture_low{0}, picture_high{0};
    glm::dvec2 middle{0}; ///< the point in the middle of its cell
    std::optional<SectionPlane> cut{};
    std::optional<SheetDetail> detail{};
    std::optional<glm::dvec2> at{}; ///< where it was placed by hand
    std::string scale{};            ///< its own, if it has one
    std::size_t shown_on = 0; ///< the side that shows a section's plane as a line, or a detail

    /// How far it reaches from the middle of its cell.
    glm::dvec2 reach() const;
};

/// The plane of a view such as "section:x=12", as it is written; nothing if the view is no section.
std::optional<std::string_view> section_of(std::string_view view);

/// The views and then the details of options, as they look at these points. Throws UsageError for a
/// section that misses the points or that no other view shows as a line, for a detail beside its
/// view, and for more of both than letters.
std::vector<SheetSide> sheet_sides(std::span<const glm::vec3> points, const Bounds& bounds,
                                   const SheetOptions& options);

} // namespace lineatlas
