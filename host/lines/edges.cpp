#include "edges.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "base/parallel.hpp"

namespace lineatlas {
namespace {

/// Radians. Faces that meet at a smaller angle are one plane to the precision of their coordinates.
/// Such an edge (a diagonal of a quad) cannot be a silhouette.
constexpr double coplanar_angle = 1e-4;

/// A triangle is a sliver if its height is below this share of its longest edge, or below this
/// share of its largest coordinate: rounding to float alone makes such heights.
constexpr double sliver_ratio = 1e-7;
constexpr double rounding_ratio = 5e-7;

/// A triangle at an edge, kept at the edge's smaller vertex. Ordered by the larger one, then by
/// triangle.
class EdgeUse {
  public:
    EdgeUse() = default;
    EdgeUse(std::uint32_t other, std::uint32_t face, bool reversed)
        : bits_(std::uint64_t{other} << 32U | std::uint64_t{face} << 1U | (reversed ? 1U : 0U)) {}

    /// The larger vertex.
    std::uint32_t other() const { return static_cast<std::uint32_t>(bits_ >> 32U); }
    std::uint32_t face() const { return static_cast<std::uint32_t>(bits_) >> 1U; }
    /// The triangle runs from the larger to the smaller vertex.
    bool reversed() const { return (bits_ & 1U) != 0; }
    auto operator<=>(const EdgeUse&) const = default;

  private:
    std::uint64_t bits_ = 0; ///< a triangle's number is below 2^31, see LA_FACE_INDEX
};

/// The uses of edges by the edge's smaller vertex, each list sorted.
Groups<EdgeUse> edge_uses(const WeldedMesh& mesh) {
    Groups<EdgeUse> uses{
        mesh.vertices.size(), mesh.triangles.size(), [&](std::size_t face, const auto& add) {
            const glm::uvec3 t = mesh.triangles[face];
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t a = t[corner], b = t[(corner + 1) % 3];
                add(std::min(a, b),
                    EdgeUse{std::max(a, b), static_cast<std::uint32_t>(face), a > b});
            }
        }};
    for_each_index(mesh.vertices.size(), [&](std::size_t v) { std::ranges::sort(uses[v]); });
    return uses;
}

std::size_t edges_among(std::span<const EdgeUse> uses) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < uses.size(); ++i)
        count += i == 0 || uses[i].other() != uses[i - 1].other() ? 1 : 0;
    return count;
}

/// Writes the edges of a vertex to larger ones from `to` on.
void write_edges(std::uint32_t vertex, std::span<const EdgeUse> uses, MeshEdge* to) {
    const EdgeUse* first_use = nullptr;
    for (const EdgeUse& use : uses) {
        if (first_use == nullptr || first_use->other() != use.other()) {
            to += first_use == nullptr ? 0 : 1;
            first_use = &use;
            *to = {.p = use.reversed() ? use.other() : vertex,
                   .q = use.reversed() ? vertex : use.other(),
                   .face_a = use.face(),
                   .face_b = LA_NO_FACE,
                   .face_count = 1};
        } else if (++to->face_count == 2) {
            const bool agrees = first_use->reversed() != use.reversed();
            to->face_b = use.face() | (agrees ? 0U : LA_FACE_FLIPPED);
        }
    }
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
    SliverReplacement(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
                      const std::vector<MeshEdge>& edges)
        : mesh_(mesh), edges_(edges), substitutes_(normals.size()), resolved_(normals.size()),
          longest_(normals.size(), 0) {
        for (std::uint32_t face = 0; face < normals.size(); ++face) {
            substitutes_[face] = {face, false};
            resolved_[face] = !is_zero(normals[face]);
        }
        for (std::uint32_t i = 0; i < edges.size(); ++i)
            if (is_open(i)) open_.push_back(i);
    }

    Substitute operator[](std::uint32_t face) const { return substitutes_[face]; }

    /// Spreads from faces with area into the slivers beside them, ring by ring, each time across
    /// the longest edge there is.
    void spread() {
        do {
            adopted_.clear();
            for (const std::uint32_t i : open_) {
                const MeshEdge& edge = edges_[i];
                const std::uint32_t b = edge.face_b & LA_FACE_INDEX;
                const bool flipped = (edge.face_b & LA_FACE_FLIPPED) != 0;
                const double length = squared_length(glm::dvec3{mesh_.vertices[edge.p]} -
                                                     glm::dvec3{mesh_.vertices[edge.q]});
                adopt(edge.face_a, b, flipped, length);
                adopt(b, edge.face_a, flipped, length);
            }
            for (const std::uint32_t sliver : adopted_) resolved_[sliver] = true;
            std::erase_if(open_, [&](std::uint32_t i) { return !is_open(i); });
        } while (!adopted_.empty());
    }

  private:
    /// Whether beside the edge there are another face and a sliver for which no face stands yet.
    bool is_open(std::uint32_t edge) const {
        const auto [p, q, a, b, count] = edges_[edge];
        return b != LA_NO_FACE && !(resolved_[a] && resolved_[b & LA_FACE_INDEX]);
    }

    void adopt(std::uint32_t sliver, std::uint32_t neighbour, bool flipped, double length) {
        if (resolved_[sliver] || !resolved_[neighbour] || length <= longest_[sliver]) return;
        const Substitute through = substitutes_[neighbour];
        substitutes_[sliver] = {through.face, through.flipped != flipped};
        longest_[sliver] = length;
        adopted_.push_back(sliver);
    }

    const WeldedMesh& mesh_;
    const std::vector<MeshEdge>& edges_;
    std::vector<Substitute> substitutes_;
    std::vector<bool> resolved_;
    std::vector<double> longest_;
    std::vector<std::uint32_t> open_;    ///< edges
    std::vector<std::uint32_t> adopted_; ///< slivers of the ring
};

} // namespace

std::vector<MeshEdge> mesh_edges(const WeldedMesh& mesh) {
    const Groups<EdgeUse> uses = edge_uses(mesh);
    const std::size_t vertices = mesh.vertices.size();
    std::vector<std::size_t> first =
        made_of_pieces<std::size_t>(vertices, usual_piece, [&](std::size_t v, std::size_t end) {
            std::size_t count = 0;
            for (; v < end; ++v) count += edges_among(uses[v]);
            return count;
        });
    const std::size_t count = std::accumulate(first.begin(), first.end(), std::size_t{0});
    std::exclusive_scan(first.begin(), first.end(), first.begin(), std::size_t{0});
    std::vector<MeshEdge> edges(count);
    for_each_piece(vertices, usual_piece, [&](std::size_t v, std::size_t end) {
        MeshEdge* to = edges.data() + first[v / usual_piece];
        for (; v < end; ++v) {
            write_edges(static_cast<std::uint32_t>(v), uses[v], to);
            to += edges_among(uses[v]);
        }
    });
    return edges;
}

std::vector<std::uint32_t> first_edges(std::size_t vertices, std::span<const MeshEdge> edges) {
    std::vector<std::uint32_t> first(vertices + 1, 0);
    for (const MeshEdge& edge : edges) ++first[std::min(edge.p, edge.q) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

void replace_slivers(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
                     std::vector<MeshEdge>& edges) {
    if (std::ranges::none_of(normals, is_zero)) return;
    SliverReplacement substitutes{mesh, normals, edges};
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
    for_each_index(normals.size(), [&](std::size_t face) {
        normals[face] = unit_normal(mesh, static_cast<std::uint32_t>(face));
    });
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
    for_each_index(edges.size(), [&](std::size_t i) {
        const MeshEdge& edge = edges[i];
        if (edge.face_count != 2) return;
        const double sign = (edge.face_b & LA_FACE_FLIPPED) != 0 ? -1 : 1;
        const glm::dvec3 a = normals[edge.face_a], b = sign * normals[edge.face_b & LA_FACE_INDEX];
        // atan2 of sine and cosine: exact for small angles, where acos is not.
        bends[i] = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    });
    return bends;
}

std::vector<bool> flat_faces(std::size_t triangles, std::span<const MeshEdge> edges,
                             std::span<const double> bends, double flat) {
    std::vector<bool> is_flat(triangles, false);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i].face_count != 2 || bends[i] >= flat) continue;
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
    if (wanted(LineKind::crease) && bend > options.crease.value_or(least_crease_angle))
        return LineKind::crease;
    if (wanted(LineKind::material) && mesh.triangle_group[edge.face_a] != mesh.triangle_group[b])
        return LineKind::material;
    if (wanted(LineKind::silhouette) && bend > coplanar_angle) return LineKind::silhouette;
    return std::nullopt;
}

} // namespace lineatlas
