#include "edges.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// Faces that meet at a smaller angle are one plane to the precision of their coordinates; such an
/// edge (a diagonal of a quad) can't be a silhouette. Radians.
constexpr double coplanar_angle = 1e-4;

/// A triangle is a sliver if its height is below this share of its longest edge, or below this
/// share of its largest coordinate: rounding to float alone makes such heights.
constexpr double sliver_ratio = 1e-7;
constexpr double rounding_ratio = 5e-7;

struct EdgeUse {
    std::uint32_t other; ///< the larger vertex
    std::uint32_t face;
    bool reversed; ///< the triangle runs from the larger to the smaller vertex
};

/// The uses of edges, grouped by their smaller vertex and sorted by the larger: uses of vertex v
/// are [first[v], first[v + 1]).
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
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        std::sort(result.uses.begin() + result.first[v], result.uses.begin() + result.first[v + 1],
                  [](const EdgeUse& a, const EdgeUse& b) {
                      return a.other != b.other ? a.other < b.other : a.face < b.face;
                  });
    }
    return result;
}

glm::dvec3 corner(const WeldedMesh& mesh, std::uint32_t face, int index) {
    return mesh.vertices[mesh.triangles[face][index]];
}

double squared_length(glm::dvec3 v) {
    return glm::dot(v, v);
}

double longest_edge(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return std::sqrt(
        std::max({squared_length(b - a), squared_length(c - a), squared_length(c - b)}));
}

/// The unit normal, or zero for a sliver.
glm::dvec3 unit_normal(const WeldedMesh& mesh, std::uint32_t face) {
    const glm::dvec3 a = corner(mesh, face, 0);
    const glm::dvec3 b = corner(mesh, face, 1);
    const glm::dvec3 c = corner(mesh, face, 2);
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double twice_area = glm::length(cross);
    const double longest = longest_edge(a, b, c);
    const glm::dvec3 extent = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
    const double coordinate = std::max({extent.x, extent.y, extent.z});
    const double least_height = std::max(sliver_ratio * longest, rounding_ratio * coordinate);
    return twice_area > least_height * longest ? cross / twice_area : glm::dvec3{0};
}

bool is_zero(glm::dvec3 v) {
    return v == glm::dvec3{0};
}

/// The triangle that stands for another one, and whether its winding disagrees with that one's.
struct Substitute {
    std::uint32_t face;
    bool flipped;
};

class SliverReplacement {
  public:
    SliverReplacement(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges)
        : mesh_(mesh), edges_(edges), substitutes_(mesh.triangles.size()),
          resolved_(mesh.triangles.size()) {
        for (std::uint32_t face = 0; face < resolved_.size(); ++face) {
            substitutes_[face] = {face, false};
            resolved_[face] = !is_zero(unit_normal(mesh, face));
            any_ = any_ || !resolved_[face];
        }
    }

    bool any() const { return any_; }
    Substitute operator[](std::uint32_t face) const { return substitutes_[face]; }

    /// Spreads from faces with area into the slivers beside them, ring by ring, each time across
    /// the longest edge there is.
    void spread() {
        for (bool changed = true; changed;) {
            changed = false;
            longest_.assign(mesh_.triangles.size(), 0);
            const std::vector<bool> before = resolved_;
            for (const MeshEdge& edge : edges_) {
                if (edge.face_b == LA_NO_FACE) continue;
                const std::uint32_t b = edge.face_b & LA_FACE_INDEX;
                const bool flipped = (edge.face_b & LA_FACE_FLIPPED) != 0;
                const double length = squared_length(glm::dvec3{mesh_.vertices[edge.p]} -
                                                     glm::dvec3{mesh_.vertices[edge.q]});
                changed |= adopt(before, edge.face_a, b, flipped, length);
                changed |= adopt(before, b, edge.face_a, flipped, length);
            }
        }
    }

  private:
    bool adopt(const std::vector<bool>& before, std::uint32_t sliver, std::uint32_t neighbour,
               bool flipped, double length) {
        if (before[sliver] || !before[neighbour] || length <= longest_[sliver]) return false;
        const Substitute through = substitutes_[neighbour];
        substitutes_[sliver] = {through.face, through.flipped != flipped};
        longest_[sliver] = length;
        resolved_[sliver] = true;
        return true;
    }

    const WeldedMesh& mesh_;
    const std::vector<MeshEdge>& edges_;
    std::vector<Substitute> substitutes_;
    std::vector<bool> resolved_;
    std::vector<double> longest_;
    bool any_ = false;
};

} // namespace

std::vector<MeshEdge> mesh_edges(const WeldedMesh& mesh) {
    const EdgeUses table = edge_uses(mesh);
    std::vector<MeshEdge> edges;
    edges.reserve(table.uses.size() / 2 + 1);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const EdgeUse* first_use = nullptr;
        for (std::uint32_t i = table.first[v]; i < table.first[v + 1]; ++i) {
            const EdgeUse& use = table.uses[i];
            if (first_use == nullptr || first_use->other != use.other) {
                first_use = &use;
                edges.push_back({.p = use.reversed ? use.other : v,
                                 .q = use.reversed ? v : use.other,
                                 .face_a = use.face,
                                 .face_b = LA_NO_FACE,
                                 .face_count = 1});
            } else if (++edges.back().face_count == 2) {
                const bool agrees = first_use->reversed != use.reversed;
                edges.back().face_b = use.face | (agrees ? 0U : LA_FACE_FLIPPED);
            }
        }
    }
    return edges;
}

void replace_slivers(const WeldedMesh& mesh, std::vector<MeshEdge>& edges) {
    SliverReplacement substitutes{mesh, edges};
    if (!substitutes.any()) return;
    substitutes.spread();
    for (MeshEdge& edge : edges) {
        const Substitute a = substitutes[edge.face_a];
        edge.face_a = a.face;
        if (edge.face_b == LA_NO_FACE) continue;
        const Substitute b = substitutes[edge.face_b & LA_FACE_INDEX];
        const bool flipped = (edge.face_b & LA_FACE_FLIPPED) != 0;
        edge.face_b = b.face | (flipped != (a.flipped != b.flipped) ? LA_FACE_FLIPPED : 0U);
    }
}

std::vector<glm::dvec3> face_normals(const WeldedMesh& mesh) {
    std::vector<glm::dvec3> normals(mesh.triangles.size());
    for (std::uint32_t face = 0; face < normals.size(); ++face) {
        normals[face] = unit_normal(mesh, face);
    }
    return normals;
}

std::size_t flat_face_count(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals) {
    std::size_t count = 0;
    for (std::uint32_t face = 0; face < normals.size(); ++face) {
        if (!is_zero(normals[face])) continue;
        const glm::dvec3 a = corner(mesh, face, 0);
        const glm::dvec3 b = corner(mesh, face, 1);
        const glm::dvec3 c = corner(mesh, face, 2);
        const double longest = longest_edge(a, b, c);
        count += glm::length(glm::cross(b - a, c - a)) <= sliver_ratio * longest * longest ? 1 : 0;
    }
    return count;
}

std::vector<double> bends_of(const std::vector<MeshEdge>& edges,
                             const std::vector<glm::dvec3>& normals) {
    std::vector<double> bends(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const MeshEdge& edge = edges[i];
        if (edge.face_count != 2) continue;
        const double sign = (edge.face_b & LA_FACE_FLIPPED) != 0 ? -1 : 1;
        const glm::dvec3 a = normals[edge.face_a], b = sign * normals[edge.face_b & LA_FACE_INDEX];
        // atan2 of sine and cosine: exact for small angles, where acos is not.
        bends[i] = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }
    return bends;
}

std::vector<bool> flat_faces(std::size_t triangles, std::span<const MeshEdge> edges,
                             std::span<const double> bends) {
    std::vector<bool> is_flat(triangles, false);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i].face_count != 2 || bends[i] >= flat_bend) continue;
        is_flat[edges[i].face_a] = true;
        is_flat[edges[i].face_b & LA_FACE_INDEX] = true;
    }
    return is_flat;
}

std::optional<LineKind> classify(const MeshEdge& edge, const WeldedMesh& mesh, double bend,
                                 const LineOptions& options) {
    const auto wanted = [&](LineKind kind) { return (options.lines & mask_of(kind)) != 0; };
    if (edge.face_count != 2) {
        return wanted(LineKind::boundary) ? std::optional{LineKind::boundary} : std::nullopt;
    }
    const std::uint32_t b = edge.face_b & LA_FACE_INDEX;
    if (wanted(LineKind::material) && mesh.triangle_group[edge.face_a] != mesh.triangle_group[b]) {
        return LineKind::material;
    }
    if (wanted(LineKind::crease) && bend > options.crease.value_or(least_crease_angle))
        return LineKind::crease;
    if (wanted(LineKind::silhouette) && bend > coplanar_angle) return LineKind::silhouette;
    return std::nullopt;
}

} // namespace lineatlas
