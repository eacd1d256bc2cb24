#include "subjects.hpp"

#include <cmath>
#include <numbers>

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
            if (factor != 1) {
                view.name += fmt::format(" x{:g}", factor);
                view.path = [path, factor](double t) {
                    View moved = path(t);
                    moved.eye = moved.target + (moved.eye - moved.target) * factor;
                    moved.near = moved.far = 0;
                    return moved;
                };
            }
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

} // namespace

std::vector<double> even_places(int count) {
    std::vector<double> places;
    for (int i = 0; i < count; ++i) places.push_back(static_cast<double>(i) / count);
    return places;
}

Subject scene_subject(const std::string& name, const Places& places) {
    const Scene scene = make_scene(name);
    const auto path = [view = scene.view](double t) { return view(static_cast<float>(t)); };
    return {name, extract_lines(scene.mesh), views_along(path, places)};
}

Subject model_subject(const std::filesystem::path& path, glm::vec3 up, glm::ivec2 size,
                      const Places& places) {
    Subject subject{path.filename().string(), extract_lines(load_mesh(path).mesh), {}};
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
