#include "weld.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "base/equal_positions.hpp"
#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "core/check_mesh.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

bool is_finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

class VertexWelder {
  public:
    VertexWelder(const Mesh& mesh, const MeshObjects& objects)
        : mesh_(mesh), has_objects_(objects.names.size() > 1),
          equal_(equal_positions(mesh.positions)), vertex_of_(mesh.positions.size(), none) {}

    std::uint32_t operator()(std::uint32_t index, std::uint32_t object) {
        std::uint32_t& first = vertex_of_[equal_[index]];
        if (first == none) return first = add(index, object);
        if (object_of(first) == object) return first;
        const std::uint64_t key = std::uint64_t{equal_[index]} << 32U | object;
        const auto [known, is_new] = of_other_objects_.try_emplace(key, none);
        if (is_new) known->second = add(index, object);
        return known->second;
    }
    std::uint32_t object_of(std::uint32_t vertex) const {
        return has_objects_ ? objects[vertex] : 0;
    }

    std::vector<glm::vec3> vertices;
    std::vector<std::uint32_t> sources; ///< per vertex its first position
    std::vector<std::uint32_t> objects; ///< per vertex; empty if all are one

  private:
    std::uint32_t add(std::uint32_t index, std::uint32_t object) {
        const glm::vec3 position = mesh_.positions[index] + 0.0F; // -0 becomes 0
        if (!is_finite(position))
            throw UsageError("mesh: position " + std::to_string(index) + " is not finite");
        vertices.push_back(position);
        sources.push_back(index);
        if (has_objects_) objects.push_back(object);
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }

    const Mesh& mesh_;
    bool has_objects_;
    std::vector<std::uint32_t> equal_;
    std::vector<std::uint32_t> vertex_of_; ///< of positions that others equal, for one object
    std::unordered_map<std::uint64_t, std::uint32_t> of_other_objects_; ///< position and object
};

glm::uvec3 sorted(glm::uvec3 t) {
    if (t.x > t.y) std::swap(t.x, t.y);
    if (t.y > t.z) std::swap(t.y, t.z);
    if (t.x > t.y) std::swap(t.x, t.y);
    return t;
}

enum class Triangle : std::uint8_t { proper, collapsed, repeated };

/// Marks triangles that have the corners of an earlier one, among triangles with the same smallest
/// vertex.
void mark_repeated(const std::vector<glm::uvec3>& triangles, std::span<std::uint32_t> of_vertex,
                   std::vector<Triangle>& kinds) {
    const auto corners = [&](std::uint32_t triangle) {
        const glm::uvec3 t = sorted(triangles[triangle]);
        return std::tuple{t.y, t.z, triangle};
    };
    std::ranges::sort(of_vertex, {}, corners);
    for (std::size_t i = 1; i < of_vertex.size(); ++i) {
        if (sorted(triangles[of_vertex[i - 1]]) == sorted(triangles[of_vertex[i]]))
            kinds[of_vertex[i]] = Triangle::repeated;
    }
}

std::vector<Triangle> kinds_of(const std::vector<glm::uvec3>& triangles, std::size_t vertices) {
    std::vector<Triangle> kinds(triangles.size(), Triangle::proper);
    for_each_index(triangles.size(), [&](std::size_t i) {
        const glm::uvec3 t = triangles[i];
        if (t.x == t.y || t.y == t.z || t.z == t.x) kinds[i] = Triangle::collapsed;
    });
    Groups<std::uint32_t> by_vertex{
        vertices, triangles.size(), [&](std::size_t i, const auto& add) {
            const glm::uvec3 t = triangles[i];
            if (kinds[i] == Triangle::proper)
                add(std::min({t.x, t.y, t.z}), static_cast<std::uint32_t>(i));
        }};
    for_each_index(vertices, [&](std::size_t v) { mark_repeated(triangles, by_vertex[v], kinds); });
    return kinds;
}

/// Puts the used vertices into the mesh, by object and within an object in their order.
void take_used_vertices(const VertexWelder& welded, std::size_t object_count, WeldedMesh& mesh) {
    std::vector<std::uint32_t> index(welded.vertices.size(), none);
    const auto for_each_index = [&](auto&& visit) {
        for (glm::uvec3& triangle : mesh.triangles) {
            for (int corner = 0; corner < 3; ++corner) visit(triangle[corner]);
        }
        for (auto& polyline : mesh.polylines) {
            for (std::uint32_t& vertex : polyline) visit(vertex);
        }
    };
    for_each_index([&](std::uint32_t vertex) { index[vertex] = 0; });
    std::vector<std::uint32_t>& next = mesh.object_ends;
    next.assign(std::max<std::size_t>(object_count, 1), 0);
    const auto for_each_used = [&](auto&& visit) {
        for (std::uint32_t v = 0; v < index.size(); ++v) {
            if (index[v] != none) visit(v, welded.object_of(v));
        }
    };
    for_each_used([&](std::uint32_t, std::uint32_t object) { ++next[object]; });
    std::exclusive_scan(next.begin(), next.end(), next.begin(), 0U);
    for_each_used([&](std::uint32_t v, std::uint32_t object) { index[v] = next[object]++; });
    mesh.vertices.resize(next.back());
    mesh.vertex_sources.resize(next.back());
    for_each_used([&](std::uint32_t v, std::uint32_t) {
        mesh.vertices[index[v]] = welded.vertices[v];
        mesh.vertex_sources[index[v]] = welded.sources[v];
    });
    for_each_index([&](std::uint32_t& vertex) { vertex = index[vertex]; });
}

} // namespace

WeldedMesh weld(const Mesh& mesh, const MeshObjects& objects) {
    check_indices(mesh);
    check_groups(mesh);
    WeldedMesh result;
    result.precision = mesh.precision;
    VertexWelder weld_vertex{mesh, objects};
    std::vector<glm::uvec3> triangles;
    triangles.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i % usual_piece == 0) ask_between_pieces();
        const glm::uvec3 t = mesh.triangles[i];
        const std::uint32_t object = objects.of_triangle(i);
        const std::uint32_t a = weld_vertex(t.x, object), b = weld_vertex(t.y, object);
        triangles.emplace_back(a, b, weld_vertex(t.z, object));
    }
    const std::vector<Triangle> kinds = kinds_of(triangles, weld_vertex.vertices.size());
    result.odd.collapsed = std::ranges::count(kinds, Triangle::collapsed);
    result.odd.repeated = std::ranges::count(kinds, Triangle::repeated);
    const std::size_t count = std::ranges::count(kinds, Triangle::proper);
    result.triangle_group.reserve(count);
    result.triangle_source.reserve(count);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i % usual_piece == 0) ask_between_pieces();
        if (kinds[i] != Triangle::proper) continue;
        triangles[result.triangle_source.size()] = triangles[i];
        result.triangle_source.push_back(static_cast<std::uint32_t>(i));
        result.triangle_group.push_back(mesh.triangle_group.empty() ? 0 : mesh.triangle_group[i]);
    }
    triangles.resize(count);
    result.triangles = std::move(triangles);
    for (std::size_t i = 0; i < mesh.polylines.size(); ++i) {
        std::vector<std::uint32_t> welded, sources;
        for (const std::uint32_t index : mesh.polylines[i]) {
            const std::uint32_t vertex = weld_vertex(index, objects.of_polyline(i));
            if (!welded.empty() && welded.back() == vertex) continue;
            welded.push_back(vertex);
            sources.push_back(index);
        }
        if (welded.size() < 2) continue;
        result.polylines.push_back(std::move(welded));
        result.polyline_sources.push_back(std::move(sources));
        result.polyline_kinds.push_back(mesh.polyline_kind.empty() ? PolylineKind::file
                                                                   : mesh.polyline_kind[i]);
    }
    take_used_vertices(weld_vertex, objects.names.size(), result);
    return result;
}

} // namespace lineatlas
