#include <algorithm>
#include <numeric>
#include <string>

#include "base/exact_bounds.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/exact_arrays.hpp"
#include "lineatlas/mesh.hpp"
#include "polygon/polygon.hpp"

namespace lineatlas {
namespace {

std::string unit_of(const MeshArrays&) {
    return "floats";
}
std::string unit_of(const ExactArrays&) {
    return "doubles";
}

/// The number of vertices. The last one may end before its stride does.
template <class Arrays>
std::size_t count_vertices(const Arrays& arrays) {
    const std::size_t numbers = arrays.positions.size(), stride = arrays.stride;
    const std::string unit = unit_of(arrays);
    if (stride < 3) throw UsageError("mesh: the stride must be at least 3 " + unit);
    const std::size_t left = numbers % stride;
    if (left == 1 || left == 2) {
        throw UsageError("mesh: " + std::to_string(numbers) + " " + unit + " at a stride of " +
                         std::to_string(stride) + " end within a vertex; the stride counts " +
                         unit + ", not bytes");
    }
    return numbers / stride + (left != 0 ? 1 : 0);
}

template <class Arrays>
void check(const Arrays& arrays, std::size_t vertices) {
    const std::size_t corners = arrays.indices.empty() ? vertices : arrays.indices.size();
    if (corners % 3 != 0) {
        throw UsageError("mesh: triangles have three corners, so " + std::to_string(corners) +
                         " cannot be all");
    }
    if (!arrays.materials.empty() && arrays.materials.size() != corners / 3) {
        throw UsageError("mesh: there are " + std::to_string(corners / 3) + " triangles and " +
                         std::to_string(arrays.materials.size()) + " materials");
    }
    for (std::size_t i = 0; i < arrays.indices.size(); ++i) {
        if (arrays.indices[i] < vertices) continue;
        throw UsageError("mesh: triangle " + std::to_string(i / 3) + " has the index " +
                         std::to_string(arrays.indices[i]) + ", but the number of vertices in " +
                         std::to_string(arrays.positions.size()) + " " + unit_of(arrays) +
                         " at a stride of " + std::to_string(arrays.stride) + " is " +
                         std::to_string(vertices) + "; the stride counts " + unit_of(arrays) +
                         ", not bytes");
    }
}

/// The positions as they are given. Throws UsageError for arrays that do not fit each other.
template <class Vector, class Arrays>
std::vector<Vector> checked_positions(const Arrays& arrays) {
    const std::size_t vertices = count_vertices(arrays);
    check(arrays, vertices);
    std::vector<Vector> positions;
    positions.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        const auto* position = arrays.positions.data() + i * arrays.stride;
        positions.emplace_back(position[0], position[1], position[2]);
    }
    return positions;
}

std::vector<std::uint32_t> corners_of(std::span<const std::uint32_t> indices,
                                      std::size_t vertices) {
    std::vector<std::uint32_t> corners{indices.begin(), indices.end()};
    if (!corners.empty()) return corners;
    corners.resize(vertices);
    std::iota(corners.begin(), corners.end(), 0U);
    return corners;
}

void add_triangles(Mesh& mesh, std::span<const std::uint32_t> corners) {
    for (std::size_t i = 0; i < corners.size(); i += 3)
        mesh.triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
}

/// Materials may be any numbers; groups are numbered from 0.
void add_groups(Mesh& mesh, std::span<const std::uint32_t> materials) {
    std::vector<std::uint32_t> numbers{materials.begin(), materials.end()};
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for (const std::uint32_t number : numbers) {
        mesh.groups.push_back({.object = {}, .material = std::to_string(number)});
    }
    for (const std::uint32_t material : materials) {
        const auto group = std::ranges::lower_bound(numbers, material) - numbers.begin();
        mesh.triangle_group.push_back(static_cast<std::uint32_t>(group));
    }
}

} // namespace

Mesh make_mesh(const MeshArrays& arrays) {
    Mesh mesh;
    mesh.positions = checked_positions<glm::vec3>(arrays);
    add_triangles(mesh, corners_of(arrays.indices, mesh.positions.size()));
    add_groups(mesh, arrays.materials);
    return mesh;
}

ExactMesh make_mesh(const ExactArrays& arrays) {
    const std::vector<glm::dvec3> positions = checked_positions<glm::dvec3>(arrays);
    const std::vector<std::uint32_t> corners = corners_of(arrays.indices, positions.size());
    ExactBounds bounds;
    bounds.add_drawable(positions, corners);
    ExactMesh made{.mesh = {}, .origin = origin_for(bounds)};
    made.mesh.positions.reserve(positions.size());
    for (const glm::dvec3& position : positions)
        made.mesh.positions.emplace_back(position - made.origin);
    add_triangles(made.mesh, corners);
    add_groups(made.mesh, arrays.materials);
    return made;
}

void add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners) {
    for (const std::uint32_t corner : corners) {
        if (corner < mesh.positions.size()) continue;
        throw UsageError("mesh: a polygon has the index " + std::to_string(corner) +
                         ", but there are " + std::to_string(mesh.positions.size()) +
                         " positions, counted from 0");
    }
    if (corners.size() >= 3) triangulate(mesh.positions, corners, mesh.triangles);
}

void add_polyline(Mesh& mesh, std::span<const glm::vec3> points) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
    std::vector<std::uint32_t>& line = mesh.polylines.emplace_back(points.size());
    std::iota(line.begin(), line.end(), first);
    if (!mesh.polyline_kind.empty()) mesh.polyline_kind.push_back(PolylineKind::file);
}

} // namespace lineatlas
