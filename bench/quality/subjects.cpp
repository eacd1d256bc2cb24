#include "subjects.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "lineatlas/io.hpp"
#include "lineatlas/scenes.hpp"

namespace lineatlas::bench {
namespace {

std::vector<PathView> views_along(const std::function<View(double)>& path, const Places& places) {
    std::vector<PathView> views;
    for (const double at : places.at) {
        for (const float factor : places.distances) {
            PathView view{fmt::format("at {:.3f}", at), at, path};
            if (factor != 1) view.name += fmt::format(" x{:g}", factor);
            view.path = [path, factor, projection = places.projection](double t) {
                View own = path(t);
                if (factor == 1 && projection == own.projection) return own;
                own.eye = own.target + (own.eye - own.target) * factor;
                own.projection = projection;
                own.near = own.far = 0;
                return own;
            };
            views.push_back(view);
        }
    }
    return views;
}

/// `v` turned by `angle` about the unit vector `axis` (Rodrigues).
glm::dvec3 turned(glm::dvec3 v, glm::dvec3 axis, double angle) {
    const double c = std::cos(angle);
    return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1 - c));
}

/// The view from within a built-in scene; nothing for other names.
std::optional<View> inside(const std::string& scene) {
    constexpr float wide = 1.0471976F; // 60 degrees
    if (scene == "clevis")
        return View{.eye = {0.09F, 0.05F, 0}, .target = {0, 0.06F, 0}, .fov_y = wide};
    if (scene == "house")
        return View{.eye = {-3.6F, 2.8F, 2.7F}, .target = {4, 2, -3}, .fov_y = wide};
    if (scene == "ship" || scene == "office") return make_scene(scene).view(0.3F);
    return std::nullopt;
}

} // namespace

std::vector<PathView> still_views(const Subject& subject, glm::vec3 up, glm::ivec2 size,
                                  Projection projection) {
    const auto still = [](const char* name, const View& view) {
        return PathView{name, 0, [view](double) { return view; }};
    };
    const std::vector<glm::vec3>& points = subject.lines.vertices;
    if (projection == Projection::orthographic) {
        std::vector<PathView> views;
        for (const char* name : {"isometric", "front"})
            views.push_back(still(name, frame_points_from(view_direction(name, up), points, size,
                                                          View{}.fov_y, projection)));
        return views;
    }
    const View front = frame_points(points, size, up);
    if (const std::optional<View> within = inside(subject.name))
        return {still("outside", front), still("inside", *within)};
    const glm::vec3 arm = glm::normalize(front.eye - front.target);
    const glm::vec3 behind = glm::normalize(2.0F * glm::dot(arm, up) * up - arm);
    return {still("front", front), still("behind", frame_points_from({behind, up}, points, size))};
}

std::vector<double> even_places(int count) {
    std::vector<double> places;
    for (int i = 0; i < count; ++i) places.push_back(static_cast<double>(i) / count);
    return places;
}

Subject scene_subject(const std::string& name, const Places& places) {
    Scene scene = make_scene(name);
    const auto path = [view = scene.view](double t) { return view(static_cast<float>(t)); };
    LineSet lines = extract_lines(scene.mesh);
    return {name, std::move(scene.mesh), std::move(lines), views_along(path, places)};
}

Subject model_subject(const std::filesystem::path& path, glm::vec3 up, glm::ivec2 size,
                      const Places& places) {
    Mesh mesh = load_mesh(path).mesh;
    LineSet lines = extract_lines(mesh);
    Subject subject{path.filename().string(), std::move(mesh), std::move(lines), {}};
    const View start = frame_points(subject.lines.vertices, size, up);
    const auto turntable = [start, up](double t) {
        View view = start;
        const glm::dvec3 arm = glm::dvec3{start.eye} - glm::dvec3{start.target};
        view.eye = glm::vec3{glm::dvec3{start.target} + turned(arm, up, 2 * std::numbers::pi * t)};
        return view;
    };
    subject.views = views_along(turntable, places);
    return subject;
}

} // namespace lineatlas::bench
