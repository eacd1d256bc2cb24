#include "sheet_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lineatlas/error.hpp"
#include "sheet_grid.hpp"
#include "sheet_marks.hpp"

namespace lineatlas {
namespace {

constexpr double parallel = 0.999; ///< cosine of axes that are one

SheetSide side_of(const std::string& name, const std::string& from,
                  std::span<const glm::vec3> points, glm::dvec3 center, glm::vec3 up) {
    const ViewDirection direction = view_direction(from, up);
    const glm::dvec3 toward{direction.toward_eye};
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3{direction.up}, toward));
    SheetSide side{.name = name,
                   .side = from,
                   .pictorial = is_pictorial(from),
                   .direction = direction,
                   .right = right,
                   .down = glm::cross(right, toward),
                   .low = glm::dvec2{std::numeric_limits<double>::infinity()},
                   .high = glm::dvec2{-std::numeric_limits<double>::infinity()}};
    for (const glm::vec3& point : points) {
        const glm::dvec3 offset = glm::dvec3{point} - center;
        const glm::dvec2 at{glm::dot(offset, side.right), glm::dot(offset, side.down)};
        side.low = glm::min(side.low, at);
        side.high = glm::max(side.high, at);
    }
    side.picture_low = side.low;
    side.picture_high = side.high;
    if (side.pictorial) side.middle = 0.5 * (side.low + side.high);
    return side;
}

/// The side that looks along the normal of a plane. Turns the normal towards it if the plane does
/// not say which side is cut away.
std::string looking_along(SectionPlane& plane, glm::vec3 up) {
    for (const char* side : {"front", "right", "top", "back", "left", "bottom"}) {
        const double along =
            glm::dot(plane.normal, glm::dvec3{view_direction(side, up).toward_eye});
        if (std::abs(along) < parallel || (plane.side_is_given && along < 0)) continue;
        if (along < 0) plane.normal = -plane.normal;
        return side;
    }
    throw UsageError("a section on a sheet needs an upward axis along x, y or z");
}

/// Throws UsageError unless some of the model lies on either side of the plane.
void check_meets(const std::string& name, const SectionPlane& plane, const Bounds& bounds,
                 glm::dvec3 origin) {
    for (int axis = 0; axis < 3; ++axis) {
        if (plane.normal[axis] == 0) continue;
        const double low = bounds.min[axis], high = bounds.max[axis];
        if (plane.point[axis] > low && plane.point[axis] < high) continue;
        throw UsageError(fmt::format("{} misses the model, which goes from {}={:g} to {:g}", name,
                                     "xyz"[axis], low + origin[axis], high + origin[axis]));
    }
}

SheetSide section_side(const std::string& name, std::span<const glm::vec3> points,
                       const Bounds& bounds, const SheetOptions& options) {
    const std::string_view text = *section_of(name);
    SectionPlane plane = parse_section(text, bounds);
    if (!text.ends_with('%')) plane.point -= options.origin;
    const std::string from = looking_along(plane, options.up);
    check_meets(name, plane, bounds, options.origin);
    const glm::dvec3 center = 0.5 * (glm::dvec3{bounds.min} + glm::dvec3{bounds.max});
    SheetSide side = side_of(name, from, points, center, options.up);
    side.cut = std::move(plane);
    return side;
}

/// The first side that shows the plane of a section as a line.
std::size_t side_with_line(const SheetSide& section, const std::vector<SheetSide>& sides) {
    const auto shows_line = [&](const SheetSide& side) {
        const double along = glm::dot(glm::dvec3{side.direction.toward_eye}, section.cut->normal);
        return !side.cut && !side.pictorial && std::abs(along) < 1 - parallel;
    };
    const auto found = std::ranges::find_if(sides, shows_line);
    if (found == sides.end())
        throw UsageError(fmt::format(
            "{}: no view shows its plane as a line; add {} to the views", section.name,
            section.side == "front" || section.side == "back" ? "top or right" : "front"));
    return static_cast<std::size_t>(found - sides.begin());
}

/// `origin`: the middle of the model in the file's coordinates.
SheetSide detail_side(const SheetDetail& detail, const std::vector<SheetSide>& sides,
                      glm::dvec3 origin) {
    const auto shown = std::ranges::find(sides, detail.view, &SheetSide::name);
    if (shown == sides.end() || shown->detail)
        throw UsageError(
            fmt::format("a detail of \"{}\": the sheet has no such view", detail.view));
    SheetSide side = *shown;
    side.side.clear();
    side.letter.clear();
    side.detail = detail;
    side.at = detail.at;
    side.scale = detail.scale;
    side.shown_on = static_cast<std::size_t>(shown - sides.begin());
    const glm::dvec3 offset = detail.center - origin;
    side.middle = {glm::dot(offset, side.right), glm::dot(offset, side.down)};
    side.low = side.middle - detail.radius;
    side.high = side.middle + detail.radius;
    const glm::dvec2 beside = glm::max(shown->low - side.middle, side.middle - shown->high);
    if (!(std::max(beside.x, beside.y) < detail.radius))
        throw UsageError(fmt::format("a detail of \"{}\": its circle about {:g},{:g},{:g} lies "
                                     "beside the model",
                                     detail.view, detail.center.x, detail.center.y,
                                     detail.center.z));
    return side;
}

void give_letters(std::vector<SheetSide>& sides) {
    std::size_t letters = 0;
    for (SheetSide& side : sides) {
        if (!side.cut && !side.detail) continue;
        if (letters == reference_letters.size())
            throw UsageError(fmt::format("a sheet has letters for {} sections and details at most",
                                         reference_letters.size()));
        side.letter.assign(1, reference_letters[letters++]);
        if (side.detail) side.name = std::string{"detail_"}.append(side.letter);
    }
}

} // namespace

glm::dvec2 SheetSide::reach() const {
    return glm::max(high - middle, middle - low);
}

std::optional<std::string_view> section_of(std::string_view view) {
    constexpr std::string_view prefix = "section:";
    if (!view.starts_with(prefix)) return {};
    return view.substr(prefix.size());
}

std::vector<SheetSide> sheet_sides(std::span<const glm::vec3> points, const Bounds& bounds,
                                   const SheetOptions& options) {
    const glm::dvec3 center = 0.5 * (glm::dvec3{bounds.min} + glm::dvec3{bounds.max});
    std::vector<SheetSide> sides;
    for (const std::string& view : options.views)
        sides.push_back(section_of(view) ? section_side(view, points, bounds, options)
                                         : side_of(view, view, points, center, options.up));
    for (const SheetPlacement& placed : options.placements) {
        SheetSide& side = *std::ranges::find(sides, placed.view, &SheetSide::name);
        side.at = placed.at;
        side.scale = placed.scale;
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (sides[i].cut) sides[i].shown_on = side_with_line(sides[i], sides);
    for (const SheetDetail& detail : options.details)
        sides.push_back(detail_side(detail, sides, center + options.origin));
    give_letters(sides);
    return sides;
}

} // namespace lineatlas
