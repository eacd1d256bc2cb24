#include "lying_faces.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "pair_key.hpp"

namespace lineatlas {
namespace {

const double same_side = std::cos(0.017453292519943295); ///< 1 degree

/// A face at an edge.
struct Side {
    std::uint32_t face;
    bool runs_along;   ///< from the edge's p to its q
    glm::dvec3 inward; ///< across the edge into the face; zero for a sliver
};

Side side_of(const WeldedMesh& mesh, const MeshEdge& edge, std::uint32_t face, int corner) {
    const glm::uvec3 t = mesh.triangles[face];
    const glm::dvec3 p = mesh.vertices[edge.p];
    const glm::dvec3 way = glm::normalize(glm::dvec3{mesh.vertices[edge.q]} - p);
    const glm::dvec3 third = glm::dvec3{mesh.vertices[t[(corner + 2) % 3]]} - p;
    const glm::dvec3 across = third - way * glm::dot(third, way);
    const double height = glm::length(across);
    const bool thin = height <= 1e-6 * glm::length(third);
    return {face, t[corner] == edge.p, thin ? glm::dvec3{0} : across / height};
}

/// All faces of the edges of more than two.
std::unordered_map<std::uint32_t, std::vector<Side>>
sides_of_crowded_edges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges) {
    std::unordered_map<std::uint64_t, std::uint32_t> crowded;
    std::vector<bool> is_end(mesh.vertices.size(), false); // most triangles have none
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (edges[i].face_count <= 2) continue;
        crowded.emplace(pair_key(edges[i].p, edges[i].q), i);
        is_end[edges[i].p] = is_end[edges[i].q] = true;
    }
    std::unordered_map<std::uint32_t, std::vector<Side>> sides;
    if (crowded.empty()) return sides;
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
        const glm::uvec3 t = mesh.triangles[face];
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = t[corner], b = t[(corner + 1) % 3];
            if (!is_end[a] || !is_end[b]) continue;
            const auto found = crowded.find(pair_key(a, b));
            if (found != crowded.end())
                sides[found->second].push_back(side_of(mesh, edges[found->second], face, corner));
        }
    }
    return sides;
}

bool on_one_side(const Side& a, const Side& b) {
    return glm::dot(a.inward, b.inward) >= same_side;
}

} // namespace

void see_lying_faces_as_one(const WeldedMesh& mesh, std::vector<MeshEdge>& edges) {
    for (const auto& [index, sides] : sides_of_crowded_edges(mesh, edges)) {
        MeshEdge& edge = edges[index];
        const Side& first = sides.front();
        const Side* other = nullptr;
        bool two_sides = first.inward != glm::dvec3{0};
        for (const Side& side : sides) {
            if (on_one_side(side, first)) continue;
            two_sides = two_sides && side.inward != glm::dvec3{0} &&
                        (other == nullptr || on_one_side(side, *other));
            const auto group_of = [&](const Side& one) { return mesh.triangle_group[one.face]; };
            const bool fits_better = other != nullptr && group_of(*other) != group_of(first) &&
                                     group_of(side) == group_of(first);
            if (other == nullptr || fits_better) other = &side;
        }
        if (!two_sides || other == nullptr) continue;
        edge.face_a = first.face;
        edge.face_b = other->face | (first.runs_along != other->runs_along ? 0U : LA_FACE_FLIPPED);
        edge.face_count = 2;
    }
}

} // namespace lineatlas
