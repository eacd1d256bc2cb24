#include "view_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/drawing_scale.hpp"
#include "lineatlas/error.hpp"
#include "values.hpp"

namespace lineatlas {
namespace {

struct ModelUnit {
    std::string_view name;
    double millimetres;
};
constexpr std::array model_units{ModelUnit{"mm", 1}, ModelUnit{"cm", 10}, ModelUnit{"m", 1000},
                                 ModelUnit{"in", 25.4}, ModelUnit{"ft", 304.8}};

double millimetres_of(const std::string& unit) {
    const auto* const known = std::ranges::find(model_units, unit, &ModelUnit::name);
    if (known == std::end(model_units)) {
        throw UsageError("--unit must be mm, cm, m, in or ft, not \"" + unit + "\"");
    }
    return known->millimetres;
}

/// Half of the smallest picture about the target that holds all points, in model units.
glm::dvec2 half_extent(const View& view, std::span<const glm::vec3> points) {
    const glm::dvec3 ahead = glm::normalize(glm::dvec3{view.target} - glm::dvec3{view.eye});
    const glm::dvec3 side = glm::normalize(glm::cross(ahead, glm::dvec3{view.up}));
    const glm::dvec3 above = glm::cross(side, ahead);
    glm::dvec2 half{0};
    for (const glm::vec3& point : points) {
        const glm::dvec3 offset = glm::dvec3{point} - glm::dvec3{view.target};
        half =
            glm::max(half, glm::abs(glm::dvec2{glm::dot(offset, side), glm::dot(offset, above)}));
    }
    return half;
}

} // namespace

void ViewOptions::declare(CLI::App& app, const std::string& group) {
    app_ = &app;
    app.add_option("--eye", eye_, "Position of the eye: X,Y,Z")->group(group);
    app.add_option("--target", target_, "The point looked at: X,Y,Z")->group(group);
    app.add_option("--up", up_,
                   "Upward axis of the model: x, y, z or X,Y,Z; auto guesses from its shape")
        ->capture_default_str()
        ->group(group);
    app.add_option("--fov", fov_, "Vertical field of view in degrees")
        ->capture_default_str()
        ->group(group);
    app.add_option("--view", view_,
                   "Side to look from: front, back, left, right, top, bottom, isometric, dimetric, "
                   "or AZIMUTH,ELEVATION in degrees")
        ->group(group);
    app.add_option("--views", views_,
                   "A sheet of several sides, as in front,top,right,isometric: aligned, to scale, "
                   "with a frame and a title block. section:x=12 is a section A-A by a plane, as "
                   "--section takes it. FILE.toml: a file with views placed by hand. auto: "
                   "front,top,right,isometric with overall sizes, axes and a scale bar, and a "
                   "summary of the model as JSON on stdout")
        ->group(group);
    app.add_option("--projection", projection_,
                   "perspective or orthographic; default orthographic with --scale or a named "
                   "--view, otherwise perspective. With --views the angle of projection, first or "
                   "third; default third")
        ->group(group);
    app.add_option("--scale", scale_,
                   "Scale of the drawing on paper, as in 1:50; needs --page or --dpi. With --views "
                   "the default is the largest scale of ISO 5455 that fits")
        ->group(group);
    app.add_option(
           "--unit", unit_,
           "Unit of the model for --scale: mm, cm, m, in or ft; by default that of the file, if it "
           "names one")
        ->capture_default_str()
        ->group(group);
}

void ViewOptions::check() const {
    if (is_sheet()) {
        for (const char* option : {"--view", "--eye", "--target", "--fov"})
            if (app_->count(option) > 0)
                throw UsageError(fmt::format(
                    "--views and {} exclude each other; leave out one of them", option));
        millimetres_of(unit_);
        return;
    }
    if (!view_.empty() && !eye_.empty())
        throw UsageError("--view and --eye exclude each other; leave out one of them");
    if (!view_.empty()) view_direction(view_, {0, 1, 0});
    const bool parallel = projection() == Projection::orthographic;
    if (to_scale()) {
        parse_scale("--scale", scale_);
        millimetres_of(unit_);
        if (!parallel) throw UsageError("--scale needs --projection orthographic");
        if (app_->count("--fov") > 0)
            throw UsageError("--scale and --fov exclude each other; leave out one of them");
    } else if (app_->count("--unit") > 0) {
        throw UsageError("--unit needs --scale or --views; add one, or leave out --unit");
    }
}

glm::vec3 ViewOptions::up(glm::vec3 otherwise) const {
    return says_up() ? parse_up("--up", up_) : otherwise;
}

float ViewOptions::fov() const {
    constexpr float radians_per_degree = std::numbers::pi_v<float> / 180;
    return fov_ * radians_per_degree;
}

double ViewOptions::unit(std::optional<double> of_file) const {
    return app_->count("--unit") > 0 || !of_file ? millimetres_of(unit_) : *of_file;
}

Projection ViewOptions::projection() const {
    if (is_sheet()) return Projection::orthographic;
    if (!projection_.empty()) return parse_projection(projection_);
    const bool named = !view_.empty() && view_.find(',') == std::string::npos;
    return named || to_scale() ? Projection::orthographic : Projection::perspective;
}

View ViewOptions::framed(std::span<const glm::vec3> points, glm::ivec2 size, glm::vec3 up) const {
    if (view_.empty()) return frame_points(points, size, up, fov(), projection());
    return frame_points_from(view_direction(view_, up), points, size, fov(), projection());
}

void ViewOptions::apply(View& view, glm::dvec3 origin, bool up_is_guessed) const {
    // The clip planes of a camera placed by hand are fitted to it.
    if (!eye_.empty()) {
        view.eye = parse_point("--eye", eye_) - origin;
        view.near = view.far = 0;
    }
    if (!target_.empty()) {
        const glm::vec3 target = parse_point("--target", target_) - origin;
        if (!view_.empty()) view.eye += target - view.target;
        view.target = target;
    }
    if (says_up() && view_.empty()) view.up = parse_up("--up", up_);
    // If the camera looks along a guessed up, that up is replaced.
    if (up_is_guessed &&
        glm::length(glm::cross(glm::normalize(view.target - view.eye), view.up)) < 1e-3F)
        view.up = std::abs(view.up.z) > 0.5F ? glm::vec3{0, 1, 0} : glm::vec3{0, 0, 1};
    if (app_->count("--fov") > 0) view.fov_y = fov();
    if (view.projection != projection()) view.near = view.far = 0;
    view.projection = projection();
}

View ViewOptions::scaled(const View& view, double millimetres, glm::ivec2 size,
                         std::span<const glm::vec3> points, std::optional<double> of_file) const {
    const bool placed = !eye_.empty() || !target_.empty();
    if (placed) points = {};
    return view_to_scale(view, scale_, unit(of_file), millimetres, size, points);
}

View view_to_scale(const View& view, const std::string& scale, double unit, double millimetres,
                   glm::ivec2 size, std::span<const glm::vec3> points) {
    const double factor = parse_scale("--scale", scale);
    const glm::dvec2 paper = millimetres * glm::dvec2{size};
    const glm::dvec2 needed = 2 * unit * half_extent(view, points); // millimetres at 1:1
    const double largest = std::min(paper.x / needed.x, paper.y / needed.y);
    if (factor > largest * (1 + 1e-6)) {
        const std::string fits = standard_scale(largest);
        throw UsageError(fmt::format("--scale {}: the model takes {:.4g} x {:.4g} mm and the "
                                     "picture has {:.4g} x {:.4g} mm on paper{}",
                                     scale, factor * needed.x, factor * needed.y, paper.x, paper.y,
                                     fits.empty() ? "" : "; " + fits + " fits"));
    }
    return with_shown_height(view, static_cast<float>(paper.y / (factor * unit)));
}

} // namespace lineatlas
