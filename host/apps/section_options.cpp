#include "section_options.hpp"

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/numbers.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

/// The direction to the eye from a place of the model.
glm::dvec3 toward_eye(const View& view, glm::dvec3 from) {
    const bool parallel = view.projection == Projection::orthographic;
    return glm::dvec3{view.eye} - (parallel ? glm::dvec3{view.target} : from);
}

} // namespace

void SectionOptions::declare(CLI::App& app, const std::string& group) {
    app_ = &app;
    app.add_option("--section", planes_,
                   "Cut the model by a plane, up to six times: x=0.3, -y=50% (of the model), or "
                   "X,Y,Z/NX,NY,NZ (point and normal). One side is cut away: with + before the "
                   "axis that of larger coordinates, with - that of smaller ones, with neither the "
                   "side towards the eye")
        ->type_name("PLANE")
        ->take_all()
        ->expected(1)
        ->group(group);
    app.add_option("--hatching", hatching_,
                   "Lines on faces of cuts: SPACING or SPACING,DEGREES in the model's unit, or "
                   "none; by default a fortieth of the cut apart and at 45 degrees")
        ->group(group);
    app.add_option("--uncut", uncut_,
                   "Leave parts of this name whole (and the parts inside them), as bolts, shafts "
                   "and ribs are drawn; * and ? stand for any letters; may be given several times")
        ->allow_extra_args(false)
        ->group(group);
}

void SectionOptions::check(bool sheet_cuts) const {
    for (const std::string& plane : planes_) parse_section(plane, {{0, 0, 0}, {1, 1, 1}});
    if (planes_.size() > most_sections)
        throw UsageError(fmt::format("--section may be given {} times at most, not {}",
                                     most_sections, planes_.size()));
    for (const char* option : {"--hatching", "--uncut"})
        if (planes_.empty() && !sheet_cuts && app_->count(option) > 0)
            throw UsageError(fmt::format("{0} needs --section, or a section of --views; add one, "
                                         "or leave out {0}",
                                         option));
    hatching();
}

Hatching SectionOptions::hatching() const {
    Hatching result;
    if (hatching_.empty()) return result;
    result.none = hatching_ == "none";
    if (result.none) return result;
    std::string_view rest = hatching_;
    const auto spacing = take_number<decltype(result.spacing)>(rest);
    std::optional<decltype(result.angle)> angle = result.angle;
    if (rest.starts_with(',')) {
        rest.remove_prefix(1);
        angle = take_number<decltype(result.angle)>(rest);
    }
    if (spacing) result.spacing = *spacing;
    if (angle) result.angle = *angle;
    const bool in_range =
        result.spacing > 0 && result.spacing < 1e15 && result.angle >= -360 && result.angle <= 360;
    if (!spacing || !angle || !rest.empty() || !in_range)
        throw UsageError("--hatching \"" + hatching_ +
                         "\" is no hatching; write a spacing as in 2.5, spacing and degrees as in "
                         "2.5,30, or none");
    return result;
}

std::vector<SectionPlane> SectionOptions::planes(const Mesh& mesh, glm::dvec3 origin,
                                                 const View& view) const {
    const Bounds bounds = bounds_of(mesh);
    std::vector<SectionPlane> planes;
    for (const std::string& text : planes_) {
        SectionPlane& plane = planes.emplace_back(parse_section(text, bounds));
        if (!text.ends_with('%')) plane.point -= origin;
        if (!plane.side_is_given && glm::dot(plane.normal, toward_eye(view, plane.point)) < 0)
            plane.normal = -plane.normal;
    }
    return planes;
}

Section SectionOptions::cut(const Mesh& mesh, glm::dvec3 origin, const View& view) const {
    return cut_mesh(mesh, planes(mesh, origin, view), hatching(), uncut_);
}

std::vector<std::string> SectionOptions::with_sides(const Mesh& mesh, glm::dvec3 origin,
                                                    const View& view) const {
    std::vector<std::string> texts = planes_;
    const std::vector<SectionPlane> cut_by = planes(mesh, origin, view);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (cut_by[i].side_is_given) continue; // without a side it is an axis
        const glm::dvec3 normal = cut_by[i].normal;
        texts[i].insert(0, 1, normal.x + normal.y + normal.z > 0 ? '+' : '-');
    }
    return texts;
}

} // namespace lineatlas::apps
