#include <algorithm>
#include <numeric>
#include <string>

#include "lineatlas/error.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {
namespace {

/// How many vertices there are; the last one may end before its stride does.
std::size_t count_vertices(const MeshArrays& arrays) {
    const std::size_t floats = arrays.positions.size(), stride = arrays.stride;
    if (stride < 3) throw UsageError("mesh: the stride must be at least 3 floats");
    const std::size_t left = floats % stride;
    if (left == 1 || left == 2) {
        throw UsageError("mesh: " + std::to_string(floats) + " floats at a stride of " +
                         std::to_string(stride) +
                         " end within a vertex; the stride counts floats, not bytes");
    }
    return floats / stride + (left != 0 ? 1 : 0);
}

void check(const MeshArrays& arrays, std::size_t vertices) {
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
                         std::to_string(arrays.positions.size()) + " floats at a stride of " +
                         std::to_string(arrays.stride) + " is " + std::to_string(vertices) +
                         "; the stride counts floats, not bytes");
    }
}

} // namespace

Mesh make_mesh(const MeshArrays& arrays) {
    const std::size_t vertices = count_vertices(arrays);
    check(arrays, vertices);
    Mesh mesh;
    mesh.positions.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        const float* position = arrays.positions.data() + i * arrays.stride;
        mesh.positions.emplace_back(position[0], position[1], position[2]);
    }
    std::vector<std::uint32_t> in_order;
    std::span<const std::uint32_t> indices = arrays.indices;
    if (indices.empty()) {
        in_order.resize(mesh.positions.size());
        std::iota(in_order.begin(), in_order.end(), 0U);
        indices = in_order;
    }
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    }
    // Materials are numbers of any size: groups are counted up.
    std::vector<std::uint32_t> numbers{arrays.materials.begin(), arrays.materials.end()};
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for (const std::uint32_t number : numbers) {
        mesh.groups.push_back({.object = {}, .material = std::to_string(number)});
    }
    for (const std::uint32_t material : arrays.materials) {
        const auto group = std::ranges::lower_bound(numbers, material) - numbers.begin();
        mesh.triangle_group.push_back(static_cast<std::uint32_t>(group));
    }
    return mesh;
}

void add_polyline(Mesh& mesh, std::span<const glm::vec3> points) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
    std::vector<std::uint32_t>& line = mesh.polylines.emplace_back(points.size());
    std::iota(line.begin(), line.end(), first);
    if (!mesh.polyline_kind.empty()) mesh.polyline_kind.push_back(PolylineKind::file);
}

} // namespace lineatlas
