#include "weld.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/first_seen.hpp"
#include "check_mesh.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// How many vertices there may be: a position is one for each object that uses it.
std::size_t most_vertices(const Mesh& mesh, const MeshObjects& objects) {
    const std::size_t positions = mesh.positions.size();
    if (objects.names.size() <= 1) return positions;
    std::vector<std::uint32_t> last_object(positions, none);
    std::size_t count = 0;
    const auto use = [&](std::uint32_t position, std::uint32_t object) {
        if (std::exchange(last_object[position], object) != object) ++count;
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            use(mesh.triangles[i][corner], objects.of_triangle(i));
    for (std::size_t i = 0; i < mesh.polylines.size(); ++i)
        for (const std::uint32_t position : mesh.polylines[i])
            use(position, objects.of_polyline(i));
    return count;
}

class VertexWelder {
  public:
    VertexWelder(const Mesh& mesh, const MeshObjects& objects)
        : mesh_(mesh), has_objects_(objects.names.size() > 1),
          welded_index_(mesh.positions.size(), none), table_(most_vertices(mesh, objects)) {}

    std::uint32_t operator()(std::uint32_t index, std::uint32_t object) {
        std::uint32_t& result = welded_index_[index];
        if (result != none && object_of(result) == object) return result;
        const glm::vec3 position = mesh_.positions[index] + 0.0F; // -0 becomes 0
        if (!std::isfinite(position.x) || !std::isfinite(position.y) ||
            !std::isfinite(position.z)) {
            throw UsageError("mesh: position " + std::to_string(index) + " is not finite");
        }
        const auto fresh = static_cast<std::uint32_t>(vertices.size());
        const std::uint32_t hash = hash_of(std::bit_cast<std::uint32_t>(position.x) + object,
                                           std::bit_cast<std::uint32_t>(position.y),
                                           std::bit_cast<std::uint32_t>(position.z));
        result = table_.find_or_add(fresh, hash, [&](std::uint32_t known) {
            return vertices[known] == position && object_of(known) == object;
        });
        if (result == fresh) {
            vertices.push_back(position);
            sources.push_back(index);
            if (has_objects_) objects.push_back(object);
        }
        return result;
    }
    std::uint32_t object_of(std::uint32_t vertex) const {
        return has_objects_ ? objects[vertex] : 0;
    }

    std::vector<glm::vec3> vertices;
    std::vector<std::uint32_t> sources; ///< per vertex its first position
    std::vector<std::uint32_t> objects; ///< per vertex; empty if all are one

  private:
    const Mesh& mesh_;
    bool has_objects_;
    std::vector<std::uint32_t> welded_index_;
    FirstSeen table_;
};

glm::uvec3 sorted(glm::uvec3 t) {
    if (t.x > t.y) std::swap(t.x, t.y);
    if (t.y > t.z) std::swap(t.y, t.z);
    if (t.x > t.y) std::swap(t.x, t.y);
    return t;
}

/// Puts the vertices that are used into the mesh: by object, else in their order.
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
    FirstSeen seen{mesh.triangles.size()};
    std::vector<glm::uvec3> keys;
    keys.reserve(mesh.triangles.size());
    result.triangles.reserve(mesh.triangles.size());
    result.triangle_group.reserve(mesh.triangles.size());
    result.triangle_source.reserve(mesh.triangles.size());

    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 source = mesh.triangles[i];
        const std::uint32_t object = objects.of_triangle(i);
        const glm::uvec3 triangle{weld_vertex(source.x, object), weld_vertex(source.y, object),
                                  weld_vertex(source.z, object)};
        const glm::uvec3 key = sorted(triangle);
        if (key.x == key.y || key.y == key.z) {
            ++result.odd.collapsed;
            continue;
        }
        const auto fresh = static_cast<std::uint32_t>(keys.size());
        const auto is_key = [&](std::uint32_t known) { return keys[known] == key; };
        if (seen.find_or_add(fresh, hash_of(key.x, key.y, key.z), is_key) != fresh) {
            ++result.odd.repeated;
            continue;
        }
        keys.push_back(key);
        result.triangles.push_back(triangle);
        result.triangle_source.push_back(static_cast<std::uint32_t>(i));
        result.triangle_group.push_back(mesh.triangle_group.empty() ? 0 : mesh.triangle_group[i]);
    }
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
