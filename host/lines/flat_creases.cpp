#include "flat_creases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "base/vertex_sets.hpp"
#include "diagonal.hpp"

namespace lineatlas {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_bend = 4 * degree; ///< hips of a square roof of 3 degrees

// The gate.
constexpr double least_flat_share = 0.3;         ///< of a part's area, in faces flat across an edge
constexpr std::uint32_t most_few_triangles = 12; ///< of a part; nothing round has so few

// Limits of large faces.
constexpr double least_size = 0.05;     ///< of a part's diagonal
constexpr double least_of_model = 0.01; ///< of the model's

// Limits of similar edges, at which the surface goes on bending.
constexpr double most_gentle = 6;        ///< times as much or as little, of gentle bends
constexpr double most_sharp = 1.5;       ///< the same of an edge that is a crease already
constexpr double parallel = 0.1;         ///< sine of the angle between edges
constexpr double most_continued = 0.45;  ///< of an edge's length, on either side
constexpr int samples = 10;              ///< of that length
constexpr std::size_t most_sides = 4096; ///< of a facet; facets of round things have fewer

bool is_line(const std::optional<LineKind>& kind) {
    return kind && kind != LineKind::silhouette;
}

double area_of(const WeldedMesh& mesh, std::uint32_t face) {
    const glm::uvec3 t = mesh.triangles[face];
    const glm::dvec3 a{mesh.vertices[t.x]}, b{mesh.vertices[t.y]}, c{mesh.vertices[t.z]};
    return glm::length(glm::cross(b - a, c - a)) / 2;
}

/// Parts that may have flat creases.
std::vector<bool> designed_parts(const WeldedMesh& mesh, const MeshParts& parts,
                                 std::span<const MeshEdge> edges, std::span<const double> bends) {
    const std::vector<bool> is_flat = flat_faces(mesh.triangles.size(), edges, bends);
    struct Part {
        double flat = 0, all = 0;
        std::uint32_t triangles = 0;
    };
    std::vector<Part> found(parts.count);
    for (std::uint32_t face = 0; face < is_flat.size(); ++face) {
        Part& part = found[parts.of_vertex[mesh.triangles[face].x]];
        const double area = area_of(mesh, face);
        part.all += area;
        if (is_flat[face]) part.flat += area;
        ++part.triangles;
    }
    std::vector<bool> designed(parts.count);
    for (std::uint32_t i = 0; i < parts.count; ++i)
        designed[i] = found[i].triangles <= most_few_triangles ||
                      found[i].flat >= least_flat_share * found[i].all;
    return designed;
}

class FlatCreaseFinder {
  public:
    FlatCreaseFinder(const WeldedMesh& mesh, const MeshParts& parts,
                     std::span<const MeshEdge> edges, std::span<const double> bends,
                     std::span<const glm::dvec3> normals,
                     std::span<const std::optional<LineKind>> kinds,
                     const std::vector<bool>& is_designed)
        : mesh_(mesh), parts_(parts), edges_(edges), bends_(bends), normals_(normals),
          kinds_(kinds), is_designed_(is_designed), least_(least_sizes()),
          candidates_(find_candidates()), facet_of_(facets()), is_asked_(asked_facets()),
          sides_(mesh.triangles.size(), candidates_.empty() ? 0 : edges.size(),
                 [&](std::size_t i, const auto& add) { add_side(i, add); }) {}

    std::vector<bool> find() const {
        std::vector<bool> found(edges_.size(), false);
        if (candidates_.empty()) return found;
        const std::vector<double> areas = facet_areas();
        for (const std::uint32_t i : candidates_)
            found[i] = is_between_large(i, areas) && !divides_warped(i) &&
                       !bends_on(i, edges_[i].face_a) && !bends_on(i, other_face(i));
        drop_loose(found);
        drop_folds(found);
        return found;
    }

  private:
    std::uint32_t other_face(std::size_t edge) const { return edges_[edge].face_b & LA_FACE_INDEX; }
    glm::dvec3 vertex(std::uint32_t i) const { return glm::dvec3{mesh_.vertices[i]}; }
    double length(const MeshEdge& edge) const {
        return glm::distance(vertex(edge.p), vertex(edge.q));
    }

    std::vector<std::uint32_t> find_candidates() const {
        std::vector<std::uint32_t> candidates;
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            const std::uint32_t part = parts_.of_vertex[edges_[i].p];
            if (!is_line(kinds_[i]) && edges_[i].face_count == 2 && bends_[i] >= least_bend &&
                bends_[i] <= double{least_crease_angle} && is_designed_[part] &&
                length(edges_[i]) >= least_[part])
                candidates.push_back(i);
        }
        return candidates;
    }

    /// Per triangle the name of its facet: the triangles in one plane with it.
    std::vector<std::uint32_t> facets() const {
        if (candidates_.empty()) return {};
        VertexSets sets{mesh_.triangles.size()};
        for (std::size_t i = 0; i < edges_.size(); ++i)
            if (edges_[i].face_count == 2 && bends_[i] < flat_bend)
                sets.unite(edges_[i].face_a, other_face(i));
        std::vector<std::uint32_t> names(mesh_.triangles.size());
        for (std::uint32_t face = 0; face < names.size(); ++face) names[face] = sets.find(face);
        return names;
    }

    /// Per facet whether it lies beside a candidate.
    std::vector<bool> asked_facets() const {
        std::vector<bool> is_asked(facet_of_.size(), false);
        for (const std::uint32_t i : candidates_)
            is_asked[facet_of_[edges_[i].face_a]] = is_asked[facet_of_[other_face(i)]] = true;
        return is_asked;
    }

    /// Edges around each facet that is asked for.
    template <class Add>
    void add_side(std::size_t i, const Add& add) const {
        const auto edge = static_cast<std::uint32_t>(i);
        const std::uint32_t a = facet_of_[edges_[i].face_a];
        const bool is_boundary = edges_[i].face_b == LA_NO_FACE;
        const std::uint32_t b = is_boundary ? a : facet_of_[other_face(i)];
        if (is_asked_[a] && (is_boundary || a != b)) add(a, edge);
        if (is_asked_[b] && a != b) add(b, edge);
    }

    /// The corner of a triangle that is no end of the edge.
    glm::dvec3 corner_beyond(std::uint32_t face, const MeshEdge& edge) const {
        const glm::uvec3 t = mesh_.triangles[face];
        for (int k = 0; k < 3; ++k)
            if (t[k] != edge.p && t[k] != edge.q) return vertex(t[k]);
        return vertex(t.x);
    }

    /// Whether the neighbour of a facet over an edge falls away behind the facet's front.
    bool falls(std::size_t edge, std::uint32_t face) const {
        const MeshEdge& one = edges_[edge];
        const std::uint32_t beyond =
            facet_of_[one.face_a] == facet_of_[face] ? other_face(edge) : one.face_a;
        return glm::dot(normals_[face], corner_beyond(beyond, one) - vertex(one.p)) < 0;
    }

    glm::dvec3 direction(std::size_t edge) const {
        return glm::normalize(vertex(edges_[edge].q) - vertex(edges_[edge].p));
    }

    bool are_parallel(std::size_t edge, std::size_t other) const {
        return glm::length(glm::cross(direction(edge), direction(other))) < parallel;
    }

    bool is_like(std::size_t edge, std::size_t other, std::uint32_t face) const {
        if (edges_[other].face_count != 2) return false;
        const bool is_gentle = bends_[other] <= double{least_crease_angle};
        const double most = is_gentle ? most_gentle : most_sharp;
        if (bends_[other] >= most * bends_[edge] || bends_[edge] >= most * bends_[other])
            return false;
        // Facets of warped surfaces bend to and fro, but not along parallel edges.
        return (is_gentle && !are_parallel(edge, other)) || falls(edge, face) == falls(other, face);
    }

    /// Whether an edge of two triangles only divides a warped surface. Where it is a hip, each
    /// triangle has one more side that is a line, and those meet at its foot.
    bool divides_warped(std::size_t edge) const {
        const std::uint32_t a = edges_[edge].face_a, b = other_face(edge);
        if (sides_[facet_of_[a]].size() != 3 || sides_[facet_of_[b]].size() != 3) return false;
        const std::optional<std::uint32_t> foot = foot_at(edge, a);
        return !foot || foot != foot_at(edge, b);
    }

    /// The end of an edge at which the only line goes on that is a side of the triangle.
    std::optional<std::uint32_t> foot_at(std::size_t edge, std::uint32_t face) const {
        const auto& [p, q, a, b, count] = edges_[edge];
        std::optional<std::uint32_t> foot;
        for (const std::uint32_t side : sides_[facet_of_[face]]) {
            if (side == edge || !is_line(kinds_[side])) continue;
            if (foot) return {};
            foot = edges_[side].p == p || edges_[side].q == p ? p : q;
        }
        return foot;
    }

    /// Whether the surface bends on as it does at an edge, across the facet of one of its faces.
    bool bends_on(std::size_t edge, std::uint32_t face) const {
        const MeshEdge& one = edges_[edge];
        const std::span<const std::uint32_t> sides = sides_[facet_of_[face]];
        const glm::dvec3 normal = normals_[face];
        if (sides.size() > most_sides || normal == glm::dvec3{0}) return false;
        const glm::dvec3 p = vertex(one.p), way = vertex(one.q) - p;
        const double length = glm::length(way);
        glm::dvec3 across = glm::normalize(glm::cross(normal, way));
        if (glm::dot(across, corner_beyond(face, one) - p) < 0) across = -across;
        int continued = 0;
        for (int i = 0; i < samples; ++i) {
            const double at = length * (i + 0.5) / samples;
            double nearest = std::numeric_limits<double>::infinity();
            std::uint32_t exit = LA_NO_FACE;
            for (const std::uint32_t side : sides) {
                if (side == edge) continue;
                // In the facet's plane: along the edge, and across it.
                const auto flat = [&](std::uint32_t v) {
                    const glm::dvec3 to = vertex(v) - p;
                    return glm::dvec2{glm::dot(to, way) / length, glm::dot(to, across)};
                };
                const glm::dvec2 a = flat(edges_[side].p), b = flat(edges_[side].q);
                if ((a.x <= at) == (b.x <= at)) continue;
                const double height = a.y + (b.y - a.y) * (at - a.x) / (b.x - a.x);
                if (height <= 1e-6 * length || height > nearest) continue;
                if (height == nearest && side > exit) continue;
                nearest = height;
                exit = side;
            }
            if (exit != LA_NO_FACE && is_like(edge, exit, face)) ++continued;
        }
        return continued > most_continued * samples;
    }

    std::vector<double> least_sizes() const {
        std::vector<glm::vec3> low(parts_.count, glm::vec3{std::numeric_limits<float>::max()});
        std::vector<glm::vec3> high(parts_.count, glm::vec3{std::numeric_limits<float>::lowest()});
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const std::uint32_t part = parts_.of_vertex[i];
            low[part] = glm::min(low[part], mesh_.vertices[i]);
            high[part] = glm::max(high[part], mesh_.vertices[i]);
        }
        const double of_model = least_of_model * diagonal_of(mesh_.vertices);
        std::vector<double> least;
        for (std::uint32_t part = 0; part < parts_.count; ++part)
            least.push_back(std::max(of_model, least_size * glm::distance(glm::dvec3{low[part]},
                                                                          glm::dvec3{high[part]})));
        return least;
    }

    std::vector<double> facet_areas() const {
        std::vector<double> areas(mesh_.triangles.size(), 0);
        for (std::uint32_t face = 0; face < areas.size(); ++face)
            areas[facet_of_[face]] += area_of(mesh_, face);
        return areas;
    }

    bool is_between_large(std::size_t edge, std::span<const double> areas) const {
        const double least = least_[parts_.of_vertex[edges_[edge].p]];
        return areas[facet_of_[edges_[edge].face_a]] >= least * least &&
               areas[facet_of_[other_face(edge)]] >= least * least;
    }

    /// A crease that does not go on in another line at both ends is none.
    void drop_loose(std::vector<bool>& found) const {
        std::vector<std::uint32_t> lines(mesh_.vertices.size(), 0);
        std::vector<std::uint32_t> loose;
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            if (!is_line(kinds_[i]) && !found[i]) continue;
            ++lines[edges_[i].p];
            ++lines[edges_[i].q];
            if (found[i]) loose.push_back(i);
        }
        for (bool dropped = true; dropped;) {
            const std::size_t before = loose.size();
            std::erase_if(loose, [&](std::uint32_t i) {
                if (lines[edges_[i].p] > 1 && lines[edges_[i].q] > 1) return false;
                --lines[edges_[i].p];
                --lines[edges_[i].q];
                found[i] = false;
                return true;
            });
            dropped = loose.size() < before;
        }
    }

    /// Creases that run from one boundary of a sheet to another are a fold of it, and no crease.
    void drop_folds(std::vector<bool>& found) const {
        VertexSets sets{mesh_.vertices.size()};
        std::vector<std::uint32_t> creases(mesh_.vertices.size(), 0);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const MeshEdge& edge = edges_[i];
            if (found[i]) sets.unite(edge.p, edge.q);
            if (!found[i] && (!is_line(kinds_[i]) || edge.face_count == 1)) continue;
            ++creases[edge.p];
            ++creases[edge.q];
        }
        std::vector<bool> is_held(mesh_.vertices.size(), false); // by another crease, or a third
        std::vector<bool> is_open(mesh_.vertices.size(), false);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const bool is_boundary = edges_[i].face_count == 1;
            for (const std::uint32_t end : {edges_[i].p, edges_[i].q}) {
                const std::uint32_t set = sets.find(end);
                if (is_boundary)
                    is_open[set] = true;
                else if (found[i] ? creases[end] > 2 : is_line(kinds_[i]))
                    is_held[set] = true;
            }
        }
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const std::uint32_t set = sets.find(edges_[i].p);
            if (found[i] && is_open[set] && !is_held[set]) found[i] = false;
        }
    }

    const WeldedMesh& mesh_;
    const MeshParts& parts_;
    std::span<const MeshEdge> edges_;
    std::span<const double> bends_;
    std::span<const glm::dvec3> normals_;
    std::span<const std::optional<LineKind>> kinds_;
    const std::vector<bool>& is_designed_;  ///< parts
    std::vector<double> least_;             ///< size that is large, per part
    std::vector<std::uint32_t> candidates_; ///< edges that are long and bend a little
    std::vector<std::uint32_t> facet_of_;   ///< triangles; none without candidates
    std::vector<bool> is_asked_;            ///< facets
    Groups<std::uint32_t> sides_;           ///< edges, by facet
};

} // namespace

std::vector<bool> flat_creases(const WeldedMesh& mesh, const MeshParts& parts,
                               std::span<const MeshEdge> edges, std::span<const double> bends,
                               std::span<const glm::dvec3> normals,
                               std::span<const std::optional<LineKind>> kinds) {
    const std::vector<bool> is_designed = designed_parts(mesh, parts, edges, bends);
    if (std::ranges::find(is_designed, true) == is_designed.end())
        return std::vector<bool>(edges.size(), false);
    return FlatCreaseFinder{mesh, parts, edges, bends, normals, kinds, is_designed}.find();
}

} // namespace lineatlas
