#include "lying_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "core/pair_key.hpp"

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

/// All faces of edges with more than two faces.
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

/// The faces in one direction from an edge.
struct Leaf {
    double angle; ///< around the edge from the first leaf on, from 0 to 2 pi
    std::vector<const Side*> sides;

    /// Whether all faces of the leaf look towards larger angles, or all towards smaller ones.
    /// Between two bodies faces look both ways.
    bool looks(bool onwards) const {
        return std::ranges::all_of(sides,
                                   [&](const Side* side) { return side->runs_along == onwards; });
    }
};

double angle_of(glm::dvec2 way) {
    const double angle = std::atan2(way.y, way.x);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// The sides of an edge by direction, once around it. Empty if a side has no direction.
std::vector<Leaf> leaves_of(const WeldedMesh& mesh, const MeshEdge& edge,
                            const std::vector<Side>& sides) {
    const glm::dvec3 way = glm::dvec3{mesh.vertices[edge.q]} - glm::dvec3{mesh.vertices[edge.p]};
    const glm::dvec3 u = sides.front().inward, v = glm::cross(glm::normalize(way), u);
    std::vector<Leaf> leaves;
    for (const Side& side : sides) {
        if (side.inward == glm::dvec3{0}) return {};
        const auto known = std::ranges::find_if(
            leaves, [&](const Leaf& leaf) { return on_one_side(*leaf.sides.front(), side); });
        if (known != leaves.end())
            known->sides.push_back(&side);
        else
            leaves.push_back(
                {angle_of({glm::dot(side.inward, u), glm::dot(side.inward, v)}), {&side}});
    }
    std::ranges::sort(leaves, {}, &Leaf::angle);
    return leaves;
}

/// Makes the edge one of two faces, which are of one group if possible.
void see_as_two(const WeldedMesh& mesh, const Leaf& one, const Leaf& two, MeshEdge& edge) {
    const auto group_of = [&](const Side* side) { return mesh.triangle_group[side->face]; };
    const Side *a = one.sides.front(), *b = two.sides.front();
    for (const Side* first : one.sides)
        for (const Side* second : two.sides)
            if (group_of(a) != group_of(b) && group_of(first) == group_of(second))
                a = first, b = second;
    edge.face_a = a->face;
    edge.face_b = b->face | (a->runs_along != b->runs_along ? 0U : LA_FACE_FLIPPED);
    edge.face_count = 2;
}

/// The places between two neighbouring leaves that look at each other, where an eye may be.
std::vector<std::size_t> open_places(const std::vector<Leaf>& leaves) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < leaves.size(); ++i)
        if (leaves[i].looks(true) && leaves[(i + 1) % leaves.size()].looks(false))
            found.push_back(i);
    return found;
}

std::vector<bool> parts_with_borders(const std::vector<MeshEdge>& edges, const MeshParts& parts) {
    std::vector<bool> has_border(parts.count, false);
    for (const MeshEdge& edge : edges)
        if (edge.face_count == 1) has_border[parts.of_vertex[edge.p]] = true;
    return has_border;
}

} // namespace

std::vector<std::uint32_t> see_lying_faces_as_one(const WeldedMesh& mesh, const MeshParts& parts,
                                                  std::vector<MeshEdge>& edges) {
    std::vector<std::uint32_t> between_bodies;
    const std::vector<bool> has_border = parts_with_borders(edges, parts);
    for (const auto& [index, sides] : sides_of_crowded_edges(mesh, edges)) {
        MeshEdge& edge = edges[index];
        const std::vector<Leaf> leaves = leaves_of(mesh, edge, sides);
        if (leaves.size() == 2) {
            see_as_two(mesh, leaves[0], leaves[1], edge);
        } else if (leaves.size() > 2 && !has_border[parts.of_vertex[edge.p]]) {
            const std::vector<std::size_t> open = open_places(leaves);
            if (open.size() != 1) continue;
            see_as_two(mesh, leaves[open[0]], leaves[(open[0] + 1) % leaves.size()], edge);
            between_bodies.push_back(index);
        }
    }
    return between_bodies;
}

} // namespace lineatlas
