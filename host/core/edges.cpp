#include "edges.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// Faces that meet at a smaller angle are one plane to the precision of their coordinates; such an edge
/// (a diagonal of a quad) can't be a silhouette. Radians.
constexpr double coplanar_angle = 1e-4;

/// A triangle whose height is below this share of its longest edge has no direction of its own.
constexpr double sliver_ratio = 1e-7;

struct EdgeUse {
    std::uint32_t other; ///< the larger vertex
    std::uint32_t face;
    bool reversed; ///< the triangle runs from the larger to the smaller vertex
};

/// The uses of edges, grouped by their smaller vertex: uses of vertex v are [first[v], first[v + 1]).
struct EdgeUses {
    std::vector<std::uint32_t> first;
    std::vector<EdgeUse> uses;
};

EdgeUses edge_uses(const WeldedMesh& mesh) {
    EdgeUses result;
    result.first.assign(mesh.vertices.size() + 1, 0);
    const auto for_each_use = [&](auto&& visit) {
        for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
            const glm::uvec3 t = mesh.triangles[face];
            for (int corner = 0; corner < 3; ++corner) visit(face, t[corner], t[(corner + 1) % 3]);
        }
    };
    for_each_use([&](std::uint32_t, std::uint32_t a, std::uint32_t b) {
        ++result.first[std::min(a, b) + 1];
    });
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) result.first[v + 1] += result.first[v];
    result.uses.resize(mesh.triangles.size() * 3);
    std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
    for_each_use([&](std::uint32_t face, std::uint32_t a, std::uint32_t b) {
        result.uses[next[std::min(a, b)]++] = {std::max(a, b), face, a > b};
    });
    return result;
}

glm::dvec3 corner(const WeldedMesh& mesh, std::uint32_t face, int index) {
    return mesh.vertices[mesh.triangles[face][index]];
}

double squared_length(glm::dvec3 v) { return glm::dot(v, v); }

/// The area-weighted normal, or zero for a sliver.
glm::dvec3 own_normal(const WeldedMesh& mesh, std::uint32_t face) {
    const glm::dvec3 a = corner(mesh, face, 0);
    const glm::dvec3 ab = corner(mesh, face, 1) - a;
    const glm::dvec3 ac = corner(mesh, face, 2) - a;
    const glm::dvec3 cross = glm::cross(ab, ac);
    const double longest =
        std::max({squared_length(ab), squared_length(ac), squared_length(ac - ab)});
    const double length = glm::length(cross);
    return length > sliver_ratio * longest ? cross / length : glm::dvec3{0};
}

bool is_zero(glm::dvec3 v) { return v == glm::dvec3{0}; }

} // namespace

std::vector<MeshEdge> mesh_edges(const WeldedMesh& mesh) {
    const EdgeUses table = edge_uses(mesh);
    std::vector<MeshEdge> edges;
    edges.reserve(table.uses.size() / 2 + 1);
    std::vector<bool> edge_reversed; // winding of face_a, for the edges of the current vertex
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const std::size_t first_edge = edges.size();
        edge_reversed.clear();
        for (std::uint32_t i = table.first[v]; i < table.first[v + 1]; ++i) {
            const EdgeUse& use = table.uses[i];
            std::size_t e = first_edge;
            while (e < edges.size() && std::max(edges[e].p, edges[e].q) != use.other) ++e;
            if (e == edges.size()) {
                edges.push_back({.p = use.reversed ? use.other : v,
                                 .q = use.reversed ? v : use.other,
                                 .face_a = use.face,
                                 .face_b = LA_NO_FACE,
                                 .face_count = 1});
                edge_reversed.push_back(use.reversed);
                continue;
            }
            if (++edges[e].face_count == 2) {
                const bool agrees = edge_reversed[e - first_edge] != use.reversed;
                edges[e].face_b = use.face | (agrees ? 0U : LA_FACE_FLIPPED);
            }
        }
    }
    return edges;
}

std::vector<glm::dvec3> face_normals(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges) {
    std::vector<glm::dvec3> normals(mesh.triangles.size());
    std::vector<double> longest_shared(mesh.triangles.size(), 0);
    bool slivers = false;
    for (std::uint32_t face = 0; face < normals.size(); ++face) {
        normals[face] = own_normal(mesh, face);
        slivers = slivers || is_zero(normals[face]);
    }
    if (!slivers) return normals;
    const std::vector<glm::dvec3> own = normals;
    for (const MeshEdge& edge : edges) {
        if (edge.face_b == LA_NO_FACE) continue;
        const std::uint32_t a = edge.face_a;
        const std::uint32_t b = edge.face_b & LA_FACE_INDEX;
        const double sign = (edge.face_b & LA_FACE_FLIPPED) != 0 ? -1 : 1;
        const double length =
            squared_length(glm::dvec3{mesh.vertices[edge.p]} - glm::dvec3{mesh.vertices[edge.q]});
        const auto adopt = [&](std::uint32_t sliver, std::uint32_t neighbour) {
            if (!is_zero(own[sliver]) || is_zero(own[neighbour])) return;
            if (length <= longest_shared[sliver]) return;
            longest_shared[sliver] = length;
            normals[sliver] = sign * own[neighbour];
        };
        adopt(a, b);
        adopt(b, a);
    }
    return normals;
}

std::optional<LineKind> classify(const MeshEdge& edge, const WeldedMesh& mesh,
                                 const std::vector<glm::dvec3>& normals,
                                 const LineOptions& options) {
    const auto wanted = [&](LineKind kind) { return (options.kinds & mask_of(kind)) != 0; };
    if (edge.face_count != 2) {
        return wanted(LineKind::boundary) ? std::optional{LineKind::boundary} : std::nullopt;
    }
    const std::uint32_t b = edge.face_b & LA_FACE_INDEX;
    if (wanted(LineKind::material) && mesh.triangle_group[edge.face_a] != mesh.triangle_group[b]) {
        return LineKind::material;
    }
    const double sign = (edge.face_b & LA_FACE_FLIPPED) != 0 ? -1 : 1;
    const glm::dvec3 normal_a = normals[edge.face_a];
    const glm::dvec3 normal_b = sign * normals[b];
    // atan2 of sine and cosine: exact for small angles, where acos is not.
    const double angle =
        std::atan2(glm::length(glm::cross(normal_a, normal_b)), glm::dot(normal_a, normal_b));
    if (wanted(LineKind::crease) && angle > options.crease_angle) return LineKind::crease;
    if (wanted(LineKind::silhouette) && angle > coplanar_angle) return LineKind::silhouette;
    return std::nullopt;
}

} // namespace lineatlas
