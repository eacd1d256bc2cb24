#include "parts.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "base/vertex_sets.hpp"

namespace lineatlas {

MeshParts find_parts(const WeldedMesh& mesh) {
    VertexSets sets{mesh.vertices.size()};
    for (const glm::uvec3& t : mesh.triangles) {
        sets.unite(t.x, t.y);
        sets.unite(t.y, t.z);
    }
    constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    MeshParts parts{.of_vertex = std::vector<std::uint32_t>(mesh.vertices.size(), unknown)};
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        std::uint32_t& of_set = parts.of_vertex[sets.find(v)];
        if (of_set == unknown) of_set = parts.count++;
        parts.of_vertex[v] = of_set;
    }
    return parts;
}

std::vector<double> enclosed_volumes(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                                     const MeshParts& parts) {
    std::vector<double> volume(parts.count, 0);
    std::vector<glm::dvec3> origin(
        parts.count); // an origin per part, because a part may be far from all others
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
        origin[parts.of_vertex[v]] = mesh.vertices[v];
    for (const glm::uvec3& t : mesh.triangles) {
        const std::uint32_t part = parts.of_vertex[t.x];
        const auto from_origin = [&](std::uint32_t v) {
            return glm::dvec3{mesh.vertices[v]} - origin[part];
        };
        const glm::dvec3 a = from_origin(t.x), b = from_origin(t.y), c = from_origin(t.z);
        volume[part] += glm::dot(a, glm::cross(b, c));
    }
    for (const MeshEdge& edge : edges) {
        const bool flipped = (edge.face_b & LA_FACE_FLIPPED) != 0;
        if (edge.face_count != 2 || flipped) volume[parts.of_vertex[edge.p]] = 0;
    }
    return volume;
}

std::vector<bool> solid_parts(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                              const MeshParts& parts) {
    std::vector<bool> solid;
    for (const double volume : enclosed_volumes(mesh, edges, parts)) solid.push_back(volume > 0);
    return solid;
}

void turn_outwards(WeldedMesh& mesh, std::vector<MeshEdge>& edges, const MeshParts& parts) {
    const std::vector<double> volume = enclosed_volumes(mesh, edges, parts);
    if (std::ranges::none_of(volume, [](double v) { return v < 0; })) return;
    mesh.turned.assign(mesh.triangles.size(), false);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        glm::uvec3& t = mesh.triangles[i];
        mesh.turned[i] = volume[parts.of_vertex[t.x]] < 0;
        if (mesh.turned[i]) std::swap(t.y, t.z);
    }
    for (MeshEdge& edge : edges)
        if (volume[parts.of_vertex[edge.p]] < 0) std::swap(edge.p, edge.q);
}

} // namespace lineatlas
