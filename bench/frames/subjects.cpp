#include "subjects.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "io/standard_streams.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/scenes.hpp"

namespace lineatlas::bench {
namespace {

constexpr LineKindMask fixed_kinds = all_line_kinds & ~mask_of(LineKind::silhouette);

/// The distance along the path from frame to frame: the path takes 10 s at 60 frames a second.
constexpr float frame_step = 1.0F / 600;

std::vector<Viewpoint> viewpoints_along(const std::function<View(float)>& path, glm::ivec2 size,
                                        const Bounds& bounds, std::size_t frames) {
    std::vector<Viewpoint> viewpoints;
    for (std::size_t i = 0; i < frames; ++i) {
        const float t = (static_cast<float>(i) + 0.5F) / static_cast<float>(frames);
        viewpoints.push_back(
            {.before = make_camera(path(std::max(0.0F, t - frame_step)), size, bounds),
             .camera = make_camera(path(t), size, bounds)});
    }
    return viewpoints;
}

/// `v` turned by `angle` about the unit vector `axis` (Rodrigues).
glm::vec3 turned(glm::vec3 v, glm::vec3 axis, float angle) {
    const float c = std::cos(angle);
    return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1 - c));
}

/// Appends a rectangle around `centre` with half its edges along `x` and `y`.
void add_wall(Mesh& mesh, glm::vec3 centre, glm::vec3 x, glm::vec3 y) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3 corner : {-x - y, x - y, x + y, -x + y}) {
        mesh.positions.push_back(centre + corner);
    }
    for (const glm::uvec3 triangle : {glm::uvec3{0, 1, 2}, glm::uvec3{0, 2, 3}}) {
        mesh.triangles.push_back(triangle + first);
        if (!mesh.groups.empty()) {
            mesh.triangle_group.push_back(static_cast<std::uint32_t>(mesh.groups.size() - 1));
        }
    }
}

/// Appends a copy of `part`, enlarged by `factor` about `eye`. Both have the same groups.
void add_enlarged(Mesh& mesh, const Mesh& part, glm::vec3 eye, float factor) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3 position : part.positions) {
        mesh.positions.push_back(eye + (position - eye) * factor);
    }
    for (const glm::uvec3 triangle : part.triangles) mesh.triangles.push_back(triangle + first);
    mesh.triangle_group.insert(mesh.triangle_group.end(), part.triangle_group.begin(),
                               part.triangle_group.end());
    for (std::vector<std::uint32_t> line : part.polylines) {
        for (std::uint32_t& index : line) index += first;
        mesh.polylines.push_back(std::move(line));
    }
}

/// A turn about what `start` looks at.
std::function<View(float)> orbit(const View& start) {
    return [start](float t) {
        View view = start;
        view.eye = view.target +
                   turned(start.eye - start.target, start.up, t * 2 * std::numbers::pi_v<float>);
        return view;
    };
}

} // namespace

Subject scene_subject(const std::string& name, glm::ivec2 size, std::size_t frames) {
    const bool silhouettes = name.ends_with("+s");
    const Scene scene = make_scene(silhouettes ? name.substr(0, name.size() - 2) : name);
    const LineKindMask kinds = silhouettes ? all_line_kinds : fixed_kinds;
    Subject subject{name, extract_lines(scene.mesh, {.lines = kinds}), kinds, {}};
    subject.viewpoints = viewpoints_along(scene.view, size, subject.lines.bounds, frames);
    return subject;
}

Subject model_subject(const std::filesystem::path& path, glm::vec3 up, bool silhouettes,
                      glm::ivec2 size, std::size_t frames) {
    const LoadedMesh loaded = load_mesh(path);
    if (!silhouettes) { // the notes are the same in the second row
        for (const std::string& note : loaded.notes) print_error("note: " + note + "\n");
    }
    return orbit_subject(path.stem().string() + (silhouettes ? "+s" : ""), loaded.mesh,
                         silhouettes ? all_line_kinds : fixed_kinds, up, size, frames);
}

Subject orbit_subject(const std::string& name, const Mesh& mesh, LineKindMask kinds, glm::vec3 up,
                      glm::ivec2 size, std::size_t frames) {
    Subject subject{name, extract_lines(mesh, {.lines = kinds}), kinds, {}};
    const View start = frame_points(mesh.positions, size, up);
    subject.viewpoints = viewpoints_along(orbit(start), size, subject.lines.bounds, frames);
    return subject;
}

std::vector<Subject> hidden_subjects(glm::ivec2 size, std::size_t frames) {
    const Mesh ship = make_scene("ship").mesh;
    View start = frame_points(ship.positions, size);
    const glm::vec3 forward = glm::normalize(start.target - start.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, start.up));
    const glm::vec3 upward = glm::cross(right, forward);

    // A cone from the eye around the ship holds the copies too. A wall across it hides all copies.
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = 0;
    glm::vec2 slope{0};
    for (const glm::vec3 position : ship.positions) {
        const glm::vec3 v = position - start.eye;
        const float depth = glm::dot(v, forward);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
        slope.x = std::max(slope.x, std::abs(glm::dot(v, right)) / depth);
        slope.y = std::max(slope.y, std::abs(glm::dot(v, upward)) / depth);
    }
    const float wall = 1.05F * farthest;
    const float factor = 1.1F * wall / nearest; // the first copy begins well behind the wall
    start.near = 0.5F * nearest;
    start.far = 2 * factor * factor * farthest;

    Mesh once = ship;
    add_wall(once, start.eye + forward * wall, right * (1.2F * slope.x * wall),
             upward * (1.2F * slope.y * wall));
    Mesh thrice = once;
    add_enlarged(thrice, ship, start.eye, factor);
    add_enlarged(thrice, ship, start.eye, factor * factor);

    const auto turn = [&](float t) {
        constexpr float most = 0.1F; // radians to either side
        View view = start;
        const float angle = most * std::sin(t * 2 * std::numbers::pi_v<float>);
        view.target = view.eye + turned(start.target - start.eye, start.up, angle);
        return view;
    };
    const LineOptions options{.lines = fixed_kinds};
    Subject one{"hidden 1x", extract_lines(once, options), fixed_kinds, {}};
    Subject three{"hidden 3x", extract_lines(thrice, options), fixed_kinds, {}};
    one.viewpoints = viewpoints_along(turn, size, one.lines.bounds, frames);
    three.viewpoints = one.viewpoints;
    return {std::move(one), std::move(three)};
}

std::vector<Subject> far_subjects(glm::ivec2 size, std::size_t frames) {
    Mesh mesh = make_scene("ship").mesh;
    const View start = frame_points(mesh.positions, size);
    const LineOptions options{.lines = fixed_kinds};
    Subject near{"far 1x", extract_lines(mesh, options), fixed_kinds, {}};
    // A twentieth of the size looks like 20 times the distance and keeps the viewpoints.
    for (glm::vec3& position : mesh.positions)
        position = start.target + (position - start.target) / 20.0F;
    Subject far{"far 20x", extract_lines(mesh, options), fixed_kinds, {}};
    near.viewpoints = viewpoints_along(orbit(start), size, near.lines.bounds, frames);
    far.viewpoints = near.viewpoints;
    return {std::move(near), std::move(far)};
}

} // namespace lineatlas::bench
