#include "sheet_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "core/drawing_scale.hpp"
#include "lineatlas/error.hpp"
#include "sheet_sides.hpp"

namespace lineatlas {
namespace {

struct NamedField {
    std::string_view name;
    std::string SheetFields::*member;
};
constexpr std::array fields{
    NamedField{"title", &SheetFields::title},     NamedField{"file", &SheetFields::file},
    NamedField{"owner", &SheetFields::owner},     NamedField{"number", &SheetFields::number},
    NamedField{"creator", &SheetFields::creator}, NamedField{"approver", &SheetFields::approver},
    NamedField{"date", &SheetFields::date},
};

/// Whether a text begins with a section whose plane is a point and a normal, as in
/// "section:1,2,3/0,0,1".
bool begins_with_oblique_section(std::string_view text) {
    std::string_view plane = section_of(text).value_or("");
    return take_number(plane).has_value();
}

/// The end of the first view in a list. It ends at a comma, but not at one between numbers: angles
/// have one, and a point with a normal has four.
std::size_t end_of_view(std::string_view list) {
    std::size_t end = std::min(list.find(','), list.size());
    const bool oblique = begins_with_oblique_section(list);
    const int within = oblique ? 4 : number_from(list.substr(0, end)) ? 1 : 0;
    for (int i = 0; i < within && end < list.size(); ++i)
        end = std::min(list.find(',', end + 1), list.size());
    return end;
}

void check_view(const std::string& view) {
    const std::optional<std::string_view> plane = section_of(view);
    if (!plane) {
        view_direction(view, {0, 1, 0});
        return;
    }
    parse_section(*plane, {{0, 0, 0}, {1, 1, 1}});
}

void check_detail(const SheetDetail& detail) {
    const glm::dvec3& center = detail.center;
    if (!(detail.radius > 0) || !std::isfinite(detail.radius + center.x + center.y + center.z))
        throw UsageError(fmt::format("a detail of \"{}\": its radius must be above 0, and its "
                                     "centre a point",
                                     detail.view));
    if (!detail.scale.empty()) parse_scale("the scale of a detail", detail.scale);
}

void check_placement(const SheetPlacement& placed, const SheetOptions& options) {
    if (std::ranges::find(options.views, placed.view) == options.views.end())
        throw UsageError(fmt::format("the view \"{}\" has a place, but the sheet does not have it",
                                     placed.view));
    if (!placed.scale.empty()) parse_scale("the scale of a view", placed.scale);
}

/// Cuts off a text up to a slash.
std::string_view take_part(std::string_view& text) {
    const std::string_view part = text.substr(0, text.find('/'));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return part;
}

std::optional<glm::dvec3> point_from(std::string_view text) {
    glm::dvec3 point{0};
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<double> value = take_number(text);
        if (!value || text.starts_with(',') != (axis < 2)) return std::nullopt;
        point[axis] = *value;
        if (axis < 2) text.remove_prefix(1);
    }
    return text.empty() ? std::optional{point} : std::nullopt;
}

} // namespace

SheetDetail parse_detail(std::string_view text) {
    std::string_view rest = text;
    SheetDetail detail{.view = std::string{take_part(rest)}};
    if (begins_with_oblique_section(text)) detail.view.append("/").append(take_part(rest));
    const std::optional<glm::dvec3> center = point_from(take_part(rest));
    const std::optional<double> radius = number_from(take_part(rest));
    if (!center || !radius)
        throw UsageError(
            fmt::format("detail \"{}\" must be a view, a point and a radius, as in "
                        "front/20,35,0/8, and perhaps a scale, as in front/20,35,0/8/5:1",
                        text));
    detail.center = *center;
    detail.radius = *radius;
    detail.scale = rest;
    check_detail(detail);
    return detail;
}

void check_sheet_options(const SheetOptions& options) {
    if (options.views.empty()) throw UsageError("a sheet needs at least one view");
    // Places are looked for one view beside the others, and a file may name any number.
    constexpr std::size_t most_views = 64;
    if (options.views.size() > most_views || options.details.size() > most_views)
        throw UsageError(fmt::format("a sheet has {} views and {} details; {} of each at most",
                                     options.views.size(), options.details.size(), most_views));
    for (auto view = options.views.begin(); view != options.views.end(); ++view) {
        check_view(*view);
        if (std::find(options.views.begin(), view, *view) != view)
            throw UsageError(
                fmt::format("the view \"{}\" is named twice; a sheet has each once", *view));
    }
    for (auto placed = options.placements.begin(); placed != options.placements.end(); ++placed) {
        check_placement(*placed, options);
        if (std::find_if(options.placements.begin(), placed, [&](const SheetPlacement& other) {
                return other.view == placed->view;
            }) != placed)
            throw UsageError(fmt::format("the view \"{}\" is placed twice", placed->view));
    }
    for (const SheetDetail& detail : options.details) check_detail(detail);
    if (!(options.unit > 0) || !std::isfinite(options.unit))
        throw UsageError("the unit of the model must be a number of millimetres above 0");
}

std::string_view name_of(ProjectionAngle angle) {
    return angle == ProjectionAngle::first ? "first" : "third";
}

ProjectionAngle parse_projection_angle(std::string_view name) {
    for (const ProjectionAngle known : {ProjectionAngle::first, ProjectionAngle::third})
        if (name_of(known) == name) return known;
    throw UsageError("unknown angle of projection \"" + std::string{name} +
                     "\"; must be first or third");
}

void set_field(SheetFields& values, std::string_view name, std::string value) {
    const auto known = std::ranges::find(fields, name, &NamedField::name);
    if (known != fields.end()) {
        values.*known->member = std::move(value);
        return;
    }
    std::string names;
    for (const NamedField& field : fields)
        names.append(names.empty() ? "" : ", ").append(field.name);
    throw UsageError("a title block has no field \"" + std::string{name} + "\"; there is " + names);
}

std::vector<std::string> parse_views(std::string_view text) {
    SheetOptions options{.views = {}};
    for (bool goes_on = true; goes_on;) {
        const std::size_t end = end_of_view(text);
        options.views.emplace_back(text.substr(0, end));
        goes_on = end < text.size();
        text.remove_prefix(goes_on ? end + 1 : end);
    }
    check_sheet_options(options);
    return options.views;
}

} // namespace lineatlas
