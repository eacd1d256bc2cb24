#include "objects.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "check_mesh.hpp"
#include "corner_normals.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "shared/constants.h"

namespace lineatlas {
namespace {

/// Nobody moves more objects one by one; a larger number is a mistake.
constexpr std::uint32_t most_objects = 1U << 24U;

bool is_finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_size(std::size_t count, std::size_t wanted, const char* what) {
    if (count == wanted) return;
    throw UsageError("mesh: there are " + std::to_string(wanted) + " " + what +
                     "s, but objects for " + std::to_string(count));
}

/// The objects of a mesh that numbers them.
MeshObjects numbered(const Mesh& mesh) {
    check_size(mesh.triangle_object.size(), mesh.triangles.size(), "triangle");
    MeshObjects result{
        .names = {}, .triangles = mesh.triangle_object, .polylines = mesh.polyline_object};
    std::uint32_t count = 1;
    for (const auto* numbers : {&result.triangles, &result.polylines}) {
        for (const std::uint32_t number : *numbers) {
            if (number >= most_objects) {
                throw UsageError("mesh: object " + std::to_string(number) + "; there may be " +
                                 std::to_string(most_objects) + " of them");
            }
            count = std::max(count, number + 1);
        }
    }
    result.names.resize(count);
    return result;
}

/// The objects of a mesh with named groups, in the order of their first appearance.
MeshObjects named(const Mesh& mesh) {
    check_groups(mesh);
    MeshObjects result;
    std::map<std::string, std::uint32_t> known;
    std::vector<std::uint32_t> of_group;
    for (const MeshGroup& group : mesh.groups) {
        const auto fresh = static_cast<std::uint32_t>(result.names.size());
        const auto [found, is_new] = known.emplace(group.object, fresh);
        if (is_new) result.names.push_back(group.object);
        of_group.push_back(found->second);
    }
    result.triangles.reserve(mesh.triangles.size());
    for (const std::uint32_t group : mesh.triangle_group)
        result.triangles.push_back(of_group[group]);
    result.polylines = mesh.polyline_object;
    return result;
}

/// The objects of the lines, or a single one for all if they name none.
std::vector<LineObject> objects_of(const LineSet& lines) {
    if (!lines.objects.empty()) return lines.objects;
    return {{.name = {}, .vertex_count = static_cast<std::uint32_t>(lines.vertices.size())}};
}

/// Calls `each` with every surface of contours and the object of the surface.
template <class Each>
void for_each_surface(const LineSet& lines, std::span<const LineObject> objects, Each&& each) {
    const KnownSurfaces& known = lines.contours.surfaces;
    std::vector<bool> is_done(known.surfaces.size(), false);
    const std::size_t first = lines.segments.size() - lines.contours.faces.size();
    for (std::size_t i = 0; i < known.of_triangle.size(); ++i) {
        const std::uint32_t surface = known.of_triangle[i];
        if (surface == KnownSurfaces::none || is_done[surface]) continue;
        is_done[surface] = true;
        const auto after = std::ranges::upper_bound(objects, lines.segments[first + i].p, {},
                                                    &LineObject::first_vertex);
        each(surface, static_cast<std::size_t>(after - objects.begin()) - 1);
    }
}

/// Turns normals as the kernel contour_turn does.
void turn_normals(LineSet& lines, std::span<const LineObject> objects,
                  std::span<const glm::mat4> world_from_object) {
    if (lines.contours.empty()) return;
    std::vector<std::uint32_t> object_of(lines.vertices.size());
    std::vector<glm::mat3> turns;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        turns.push_back(normal_turn(world_from_object[i]));
        std::ranges::fill(
            std::span{object_of}.subspan(objects[i].first_vertex, objects[i].vertex_count),
            static_cast<std::uint32_t>(i));
    }
    for (ContourCorner& corner : lines.contours.corners) {
        const glm::mat3& turn = turns[object_of[corner.vertex]];
        glm::vec3 normal = turn * glm::vec3{corner.normal[0], corner.normal[1], corner.normal[2]};
        const float square = glm::dot(normal, normal);
        if (std::abs(square - 1) > 1e-6F && square > 0) normal /= std::sqrt(square);
        for (int axis = 0; axis < 3; ++axis) corner.normal[axis] = normal[axis];
    }
}

} // namespace

MeshObjects find_objects(const Mesh& mesh) {
    const bool by_number = !mesh.triangle_object.empty() || !mesh.polyline_object.empty();
    if (by_number && !mesh.polyline_object.empty()) {
        check_size(mesh.polyline_object.size(), mesh.polylines.size(), "polyline");
    }
    if (!by_number && mesh.triangle_group.empty())
        return {.names = {""}, .triangles = {}, .polylines = {}};
    MeshObjects result = by_number ? numbered(mesh) : named(mesh);
    if (result.polylines.empty() && !mesh.polylines.empty()) {
        result.polylines.assign(mesh.polylines.size(),
                                static_cast<std::uint32_t>(result.names.size()));
        result.names.emplace_back();
    }
    return result;
}

Bounds moved(const Bounds& box, const glm::mat4& world_from_object) {
    if (!(box.min.x <= box.max.x)) return box;
    const glm::vec3 middle = 0.5F * (box.min + box.max), half_size = 0.5F * (box.max - box.min);
    const glm::mat3 m{world_from_object};
    const glm::vec3 at = m * middle + glm::vec3{world_from_object[3]};
    const glm::vec3 reach =
        glm::abs(m[0]) * half_size.x + glm::abs(m[1]) * half_size.y + glm::abs(m[2]) * half_size.z;
    // A little larger, so that no vertex that is rounded differently lies outside.
    const glm::vec3 most = reach + LA_BOX_ROUNDING * (reach + glm::abs(at));
    return {at - most, at + most};
}

glm::mat3 normal_turn(const glm::mat4& world_from_object) {
    const glm::dmat3 m{world_from_object};
    const glm::dmat3 cofactors{glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1])};
    const double determinant = glm::dot(m[0], cofactors[0]);
    if (determinant == 0) return glm::mat3{0};
    // A matrix that neither stretches nor skews keeps the lengths of normals.
    const double size = std::cbrt(determinant);
    return glm::mat3{cofactors / std::copysign(size * size, determinant)};
}

void check_transforms(std::span<const glm::mat4> world_from_object, std::size_t count) {
    if (world_from_object.size() != count) {
        throw UsageError("renderer: there are " + std::to_string(count) + " objects, but " +
                         std::to_string(world_from_object.size()) + " matrices");
    }
    // Axes with less volume lie nearly in one plane; their lengths do not matter.
    constexpr double least_volume = 1e-6;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::mat4& m = world_from_object[i];
        const auto refuse = [&](const char* what) {
            throw UsageError("renderer: the matrix of object " + std::to_string(i) + " " + what);
        };
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                if (!std::isfinite(m[column][row])) refuse("is not finite");
            }
        }
        if (m[0].w != 0 || m[1].w != 0 || m[2].w != 0 || m[3].w != 1) refuse("is not affine");
        const glm::dmat3 axes{m};
        const double lengths = glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
        if (!(std::abs(glm::determinant(axes)) > least_volume * lengths)) refuse("is singular");
    }
}

void check_objects(std::span<const std::uint32_t> hidden, std::size_t count) {
    for (const std::uint32_t object : hidden) {
        if (object < count) continue;
        throw UsageError("renderer: there is no object " + std::to_string(object) +
                         " to hide, but " + std::to_string(count) + " objects");
    }
}

void hide_objects(LineSet& lines, std::span<const std::uint32_t> hidden) {
    const std::vector<LineObject> objects = objects_of(lines);
    check_objects(hidden, objects.size());
    // Hidden objects shrink to a point of an object that is still shown. So they
    // do not enlarge the region that a camera must show.
    std::vector<bool> shown(objects.size(), true);
    for (const std::uint32_t object : hidden) shown[object] = false;
    glm::vec3 point = 0.5F * (lines.bounds.min + lines.bounds.max);
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (shown[i] && objects[i].vertex_count > 0)
            point = lines.vertices[objects[i].first_vertex];
    KnownSurfaces& known = lines.contours.surfaces;
    std::vector<bool> goes(known.surfaces.size(), false);
    for_each_surface(lines, objects, [&](std::uint32_t surface, std::size_t object) {
        goes[surface] = !shown[object];
    });
    for (std::uint32_t& surface : known.of_triangle)
        if (surface != KnownSurfaces::none && goes[surface]) surface = KnownSurfaces::none;
    for (const std::uint32_t object : hidden) {
        const LineObject& one = objects[object];
        std::ranges::fill(std::span{lines.vertices}.subspan(one.first_vertex, one.vertex_count),
                          point);
    }
}

void move_vertices(LineSet& lines, std::span<const glm::vec3> positions) {
    const auto last = std::ranges::max_element(lines.vertex_sources);
    if (last != lines.vertex_sources.end() && *last >= positions.size()) {
        throw UsageError("mesh: vertices come from " + std::to_string(*last + 1) +
                         " positions, but there are " + std::to_string(positions.size()));
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (is_finite(positions[i])) continue;
        throw UsageError("mesh: position " + std::to_string(i) + " is not finite");
    }
    for (std::size_t i = 0; i < lines.vertices.size(); ++i)
        lines.vertices[i] = positions[lines.vertex_sources[i]];
    for (const CutVertex& cut : lines.cut_vertices) {
        const glm::vec3 from = lines.vertices[cut.from], to = lines.vertices[cut.to];
        lines.vertices[cut.vertex] = from + cut.share * (to - from);
    }
    lines.bounds = {};
    for (const glm::vec3& v : lines.vertices) {
        lines.bounds.min = glm::min(lines.bounds.min, v);
        lines.bounds.max = glm::max(lines.bounds.max, v);
    }
    find_normals(lines);
    lines.contours.surfaces = {}; // the surfaces have bent
}

void move_objects(LineSet& lines, std::span<const glm::mat4> world_from_object) {
    const std::vector<LineObject> objects = objects_of(lines);
    check_transforms(world_from_object, objects.size());
    turn_normals(lines, objects, world_from_object);
    for_each_surface(lines, objects, [&](std::uint32_t surface, std::size_t object) {
        glm::dmat4x3& placed = lines.contours.surfaces.surfaces[surface].model_from_shape;
        placed = glm::dmat4x3{glm::dmat4{world_from_object[object]} * glm::dmat4{placed}};
    });
    lines.bounds = {};
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const glm::mat4& m = world_from_object[i];
        const std::span vertices =
            std::span{lines.vertices}.subspan(objects[i].first_vertex, objects[i].vertex_count);
        for (glm::vec3& v : vertices) {
            // As the stage `transform` does, to the last bit.
            v = glm::vec3{(m[0] * v.x + m[1] * v.y) + (m[2] * v.z + m[3])};
            lines.bounds.min = glm::min(lines.bounds.min, v);
            lines.bounds.max = glm::max(lines.bounds.max, v);
        }
    }
}

} // namespace lineatlas
