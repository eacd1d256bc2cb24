#include "sheet_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lineatlas/error.hpp"
#include "sheet_grid.hpp"
#include "sheet_marks.hpp"

namespace lineatlas {
namespace {

/// `from`: the named side or the angles that it looks from; empty: an oblique section.
SheetSide side_of(const std::string& name, const std::string& from, const ViewDirection& direction,
                  std::span<const glm::vec3> points, glm::dvec3 center) {
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

/// The named side that looks along the normal of a plane; empty if none does.
std::string looking_along(const glm::dvec3& normal, glm::vec3 up) {
    constexpr double parallel = 1 - 1e-9; // cosine
    for (const char* side : {"front", "right", "top", "back", "left", "bottom"})
        if (glm::dot(normal, glm::dvec3{view_direction(side, up).toward_eye}) > parallel)
            return side;
    return {};
}

/// The plane of a section in the coordinates of the points, with a unit normal. If the text does
/// not say which side is cut away, it is the side from which the front, the right and the top look.
SectionPlane plane_of(const std::string& name, const Bounds& bounds, const SheetOptions& options) {
    const std::string_view text = *section_of(name);
    SectionPlane plane = parse_section(text, bounds);
    if (!text.ends_with('%')) plane.point -= options.origin;
    const glm::dvec3 size = glm::abs(plane.normal);
    plane.normal = glm::normalize(plane.normal / std::max({size.x, size.y, size.z}));
    glm::dvec3 usual{0};
    for (const char* side : {"front", "right", "top"})
        usual += glm::dvec3{view_direction(side, options.up).toward_eye};
    if (!plane.side_is_given && glm::dot(plane.normal, usual) < 0) plane.normal = -plane.normal;
    return plane;
}

/// Throws UsageError unless some of the model lies on either side of the plane.
void check_meets(const std::string& name, const SectionPlane& plane,
                 std::span<const glm::vec3> points, const Bounds& bounds, glm::dvec3 origin) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const glm::vec3& point : points) {
        const double height = glm::dot(glm::dvec3{point} - plane.point, plane.normal);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (low < 0 && high > 0) return;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(plane.normal[axis]) == 1)
            throw UsageError(fmt::format("{} misses the model, which goes from {}={:g} to {:g}",
                                         name, "xyz"[axis], bounds.min[axis] + origin[axis],
                                         bounds.max[axis] + origin[axis]));
    throw UsageError(fmt::format("{} misses the model, which goes from {:g} to {:g} along the "
                                 "plane's normal, counted from the plane",
                                 name, low, high));
}

/// How a section is seen whose plane is a line on `shown`: turned about that line, as
/// projection has it.
ViewDirection turned_about_line(const SheetSide& shown, glm::dvec3 normal) {
    const glm::dvec2 on_paper =
        glm::normalize(glm::dvec2{glm::dot(normal, shown.right), glm::dot(normal, shown.down)});
    const glm::dvec3 line = -on_paper.y * shown.right + on_paper.x * shown.down;
    const glm::dvec3 up = on_paper.y * glm::dvec3{shown.direction.toward_eye} - on_paper.x * line;
    return {.toward_eye = normal, .up = up};
}

/// A view in which a plane would be a line.
std::string view_along(const glm::dvec3& normal, glm::vec3 up) {
    const auto along = [&](const char* side) {
        return glm::dot(normal, glm::dvec3{view_direction(side, up).toward_eye});
    };
    constexpr double small = 1e-6;
    if (std::abs(along("front")) < small) return "front";
    if (std::abs(along("top")) < small) return "top";
    if (std::abs(along("right")) < small) return "right";
    const double azimuth = std::atan2(-along("front"), along("right"));
    return fmt::format("{:.5g},0", glm::degrees(azimuth));
}

/// The first side that shows the plane of a section as a line, if there is one an aligned side.
std::size_t side_with_line(const std::string& name, glm::dvec3 normal,
                           const std::vector<SheetSide>& sides, glm::vec3 up) {
    for (const bool pictorial : {false, true}) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            constexpr double flat = 1e-3; // sine
            const double along = glm::dot(glm::dvec3{sides[i].direction.toward_eye}, normal);
            if (!section_of(sides[i].name) && sides[i].pictorial == pictorial &&
                std::abs(along) < flat)
                return i;
        }
    }
    throw UsageError(fmt::format("{}: no view shows its plane as a line; add {} to the views", name,
                                 view_along(normal, up)));
}

/// `sides`: the views that are no sections stand at their places.
SheetSide section_side(const std::string& name, const std::vector<SheetSide>& sides,
                       std::span<const glm::vec3> points, const Bounds& bounds,
                       const SheetOptions& options) {
    SectionPlane plane = plane_of(name, bounds, options);
    check_meets(name, plane, points, bounds, options.origin);
    const std::size_t shown_on = side_with_line(name, plane.normal, sides, options.up);
    const std::string from = looking_along(plane.normal, options.up);
    const ViewDirection direction = from.empty() ? turned_about_line(sides[shown_on], plane.normal)
                                                 : view_direction(from, options.up);
    const glm::dvec3 center = 0.5 * (glm::dvec3{bounds.min} + glm::dvec3{bounds.max});
    SheetSide side = side_of(name, from, direction, points, center);
    side.cut = std::move(plane);
    side.shown_on = shown_on;
    return side;
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
    std::vector<SheetSide> sides(options.views.size());
    for (const bool sections : {false, true}) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const std::string& view = sides[i].name = options.views[i];
            if (section_of(view).has_value() != sections) continue;
            sides[i] = sections
                           ? section_side(view, sides, points, bounds, options)
                           : side_of(view, view, view_direction(view, options.up), points, center);
        }
    }
    for (const SheetPlacement& placed : options.placements) {
        SheetSide& side = *std::ranges::find(sides, placed.view, &SheetSide::name);
        side.at = placed.at;
        side.scale = placed.scale;
    }
    for (const SheetDetail& detail : options.details)
        sides.push_back(detail_side(detail, sides, center + options.origin));
    give_letters(sides);
    return sides;
}

} // namespace lineatlas
