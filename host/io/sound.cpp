#include "sound.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/exact_bounds.hpp"

namespace lineatlas {
namespace {

constexpr double rounding = 1 + 1e-6; ///< of floats

/// Whether a number is from 0 to the largest that a file may have; false for NaN.
bool is_length(double value) {
    return value >= 0 && value <= largest_drawable * rounding;
}

/// Whether a point may be a position of a file, less an origin.
bool is_position(glm::vec3 v) {
    return is_drawable(glm::dvec3{v} / (2 * rounding));
}

bool is_color(glm::vec3 v) {
    const auto is_share = [](float share) { return share >= 0 && share <= 1; };
    return is_share(v.x) && is_share(v.y) && is_share(v.z);
}

/// Whether a vector is a unit vector; false for NaN.
bool is_direction(glm::vec3 v) {
    constexpr float most_off = 1e-3F;
    return std::abs(glm::dot(v, v) - 1) <= most_off;
}

bool is_normal(glm::vec3 v) {
    return v == glm::vec3{0} || is_direction(v);
}

/// Whether there is one number below `count` for each of `elements`, or none at all.
bool are_numbers(const std::vector<std::uint32_t>& numbers, std::size_t elements,
                 std::size_t count) {
    const bool wanted = count > 0;
    return numbers.size() == (wanted ? elements : 0) &&
           std::ranges::all_of(numbers, [&](std::uint32_t number) { return number < count; });
}

bool is_tree(const std::vector<ModelPart>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const ModelPart& part = parts[i];
        if (part.parent != ModelPart::none && part.parent >= i) return false;
        if (part.object != ModelPart::none && part.object >= parts.size()) return false;
    }
    return true;
}

/// Whether a mesh is large enough for floats to hold the squares of its lengths.
bool has_extent(const Mesh& mesh) {
    ExactBounds bounds;
    for (const glm::vec3& position : mesh.positions) bounds.add(glm::dvec3{position});
    return bounds.extent() * rounding >= smallest_extent;
}

bool is_sound(const Mesh& mesh) {
    const auto is_vertex = [&](std::uint32_t index) { return index < mesh.positions.size(); };
    const auto is_triangle = [&](glm::uvec3 corners) {
        return is_vertex(corners.x) && is_vertex(corners.y) && is_vertex(corners.z);
    };
    const auto is_line = [&](const std::vector<std::uint32_t>& line) {
        return line.size() >= 2 && std::ranges::all_of(line, is_vertex) &&
               std::ranges::adjacent_find(line) == line.end();
    };
    const auto is_edge = [&](const KnownEdge& edge) {
        return is_vertex(edge.from) && is_vertex(edge.to) && edge.kind <= KnownEdge::Kind::wire;
    };
    const auto is_curve = [](const std::optional<EdgeCurve>& curve) {
        return !curve || (is_finite(curve->center) && is_finite(curve->u) && is_finite(curve->v));
    };
    const auto has_color = [](const MeshGroup& group) {
        return !group.color || is_color(*group.color);
    };
    return !mesh.empty() && std::ranges::all_of(mesh.positions, is_position) && has_extent(mesh) &&
           std::ranges::all_of(mesh.triangles, is_triangle) &&
           std::ranges::all_of(mesh.polylines, is_line) &&
           std::ranges::all_of(mesh.known_edges, is_edge) &&
           std::ranges::all_of(mesh.edge_curves, is_curve) &&
           std::ranges::all_of(mesh.groups, has_color) &&
           are_numbers(mesh.triangle_group, mesh.triangles.size(), mesh.groups.size()) &&
           (mesh.corner_normals.empty() ||
            mesh.corner_normals.size() == 3 * mesh.triangles.size()) &&
           std::ranges::all_of(mesh.corner_normals, is_normal) &&
           is_sound(mesh.surfaces, mesh.triangles.size()) && is_length(mesh.precision);
}

} // namespace

bool is_sound(const LoadedMesh& loaded) {
    constexpr double least_unit = 1e-15; // millimetres
    const Mesh& mesh = loaded.mesh;
    const std::size_t objects = loaded.parts.size();
    return is_sound(mesh) && is_tree(loaded.parts) &&
           are_numbers(mesh.triangle_object, mesh.triangles.size(), objects) &&
           are_numbers(mesh.polyline_object, mesh.polylines.size(), objects) &&
           is_drawable(loaded.origin) && is_length(loaded.deflection) &&
           (!loaded.up || is_direction(*loaded.up)) &&
           (!loaded.unit || (*loaded.unit >= least_unit && is_length(*loaded.unit)));
}

bool is_sound(const Image& image) {
    const glm::ivec2 size = image.size;
    return size.x > 0 && size.y > 0 && image.channels >= 1 && image.channels <= 4 &&
           image.pixels.size() == static_cast<std::size_t>(size.x) *
                                      static_cast<std::size_t>(size.y) *
                                      static_cast<std::size_t>(image.channels);
}

} // namespace lineatlas
