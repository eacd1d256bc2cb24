#include "seams.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "base/stretches.hpp"
#include "core/contact.hpp"
#include "diagonal.hpp"

namespace lineatlas {
namespace {

// Shares of the model's diagonal.
constexpr double beyond = 1e-4;     ///< how far beside an edge a face must go on
constexpr double same_plane = 3e-5; ///< how far apart faces of one plane may lie
constexpr double least_part = 1e-3; ///< shorter parts are neither lines nor seams

constexpr double most_bend = 0.017453292519943295; ///< of faces in one plane: 1 degree
const double least_cosine = std::cos(most_bend);

/// Shares of an edge: ascending, apart from each other.
using Stretches = std::vector<Stretch>;

Stretches both(const Stretches& a, const Stretches& b) {
    Stretches result;
    for (const Stretch one : a) {
        for (const Stretch other : b) {
            const Stretch common{std::max(one.from, other.from), std::min(one.to, other.to)};
            if (common.from < common.to) result.push_back(common);
        }
    }
    return result;
}

Stretches either(Stretches a, const Stretches& b, double gap) {
    a.insert(a.end(), b.begin(), b.end());
    join_stretches(a, gap);
    return a;
}

/// Narrows s, from `stretch.from` to `stretch.to`, to where a linear function is not below 0. at_0,
/// at_1: its values at 0 and 1.
void keep_above(Stretch& stretch, double at_0, double at_1) {
    if (at_0 < 0 && at_1 < 0) {
        stretch.to = stretch.from;
    } else if (at_0 < 0) {
        stretch.from = std::max(stretch.from, at_0 / (at_0 - at_1));
    } else if (at_1 < 0) {
        stretch.to = std::min(stretch.to, at_0 / (at_0 - at_1));
    }
}

class SeamFinder {
  public:
    SeamFinder(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
               const TriangleTrees& trees, const SeamSurfaces& surfaces)
        : mesh_(mesh), normals_(normals), trees_(trees), surfaces_(surfaces),
          diagonal_(diagonal_of(mesh.vertices)),
          same_plane_(std::max(same_plane * diagonal_, contact_of(diagonal_, mesh.precision))) {}

    /// Where the edge is a seam.
    Stretches of_boundary(const MeshEdge& edge) {
        const std::optional<Side> a = side(edge, edge.face_a);
        if (!a) return {};
        find_near(edge, std::array{normals_[a->face]});
        return covered(edge, *a, beyond, surfaces_.material);
    }
    Stretches of_crease(const MeshEdge& edge) {
        const std::optional<Side> a = side(edge, edge.face_a);
        const std::optional<Side> b = side(edge, edge.face_b & LA_FACE_INDEX);
        if (!a || !b) return {};
        find_near(edge, std::array{normals_[a->face], normals_[b->face]});
        if (near_.empty()) return {};
        const Stretches a_goes_on = covered(edge, *a, beyond, surfaces_.body);
        const Stretches b_goes_on = covered(edge, *b, beyond, surfaces_.body);
        const double gap = least(edge);
        Stretches result;
        if (!a_goes_on.empty())
            result = both(a_goes_on, either(b_goes_on, covered(edge, *b, -beyond, {}), gap));
        if (!b_goes_on.empty()) {
            const Stretches covered_a = either(a_goes_on, covered(edge, *a, -beyond, {}), gap);
            result = either(result, both(b_goes_on, covered_a), gap);
        }
        return result;
    }
    /// The shortest part of the edge that counts.
    double least(const MeshEdge& edge) const {
        return least_part * diagonal_ / glm::distance(at(edge.p), at(edge.q));
    }

  private:
    /// A face of an edge, and the direction in its plane away from it.
    struct Side {
        std::uint32_t face;
        glm::dvec3 outward;
    };

    glm::dvec3 at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }

    std::optional<Side> side(const MeshEdge& edge, std::uint32_t face) const {
        const glm::uvec3 t = mesh_.triangles[face];
        int common = 0;
        std::uint32_t third = t.x;
        for (int k = 0; k < 3; ++k) {
            const bool of_edge = t[k] == edge.p || t[k] == edge.q;
            common += of_edge ? 1 : 0;
            if (!of_edge) third = t[k];
        }
        // A face without this edge or without a normal stands for a sliver.
        if (common != 2 || normals_[face] == glm::dvec3{0}) return {};
        glm::dvec3 outward = glm::cross(at(edge.q) - at(edge.p), normals_[face]);
        outward = glm::normalize(outward);
        if (glm::dot(outward, at(third) - at(edge.p)) > 0) outward = -outward;
        return Side{face, outward};
    }

    /// Finds faces near the edge, except its own, that may lie along one of the normals.
    void find_near(const MeshEdge& edge, std::span<const glm::dvec3> along) {
        const auto reach = static_cast<float>(2 * beyond * diagonal_);
        const glm::vec3 p = mesh_.vertices[edge.p], q = mesh_.vertices[edge.q];
        near_.clear();
        const auto keep = [&](std::uint32_t t) {
            if (t != edge.face_a && t != (edge.face_b & LA_FACE_INDEX)) near_.push_back(t);
        };
        trees_.of_triangle(edge.face_a)
            .visit_along({glm::min(p, q) - reach, glm::max(p, q) + reach}, along, most_bend,
                         surfaces_.closed_part[edge.face_a], keep);
    }

    /// The stretches where some face in the plane of this one covers the line beside the edge,
    /// `away` outwards. surface: if it is not empty, only faces of the same surface count.
    Stretches covered(const MeshEdge& edge, const Side& side, double away,
                      std::span<const std::uint32_t> surface) const {
        const glm::dvec3 move = side.outward * (away * diagonal_);
        const glm::dvec3 a = at(edge.p) + move, b = at(edge.q) + move;
        Stretches stretches;
        for (const std::uint32_t face : near_) {
            if (!surface.empty() && surface[face] != surface[side.face]) continue;
            const double cosine = glm::dot(normals_[face], normals_[side.face]);
            if (std::abs(cosine) < least_cosine) continue;
            const Stretch stretch = part_over(face, a, b);
            if (stretch.from < stretch.to) stretches.push_back(stretch);
        }
        join_stretches(stretches, least(edge));
        std::erase_if(stretches, [&](const Stretch& stretch) {
            return stretch.to - stretch.from < least(edge) && (stretch.from > 0 || stretch.to < 1);
        });
        return stretches;
    }

    /// The part of the way from a to b that lies in a face.
    Stretch part_over(std::uint32_t face, glm::dvec3 a, glm::dvec3 b) const {
        const glm::uvec3 t = mesh_.triangles[face];
        const glm::dvec3 normal = normals_[face];
        const double height_a = glm::dot(normal, a - at(t.x));
        const double height_b = glm::dot(normal, b - at(t.x));
        const double most = same_plane_;
        Stretch stretch{0, 1};
        keep_above(stretch, most - height_a, most - height_b);
        keep_above(stretch, most + height_a, most + height_b);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 from = at(t[k]);
            const glm::dvec3 inward = glm::cross(normal, at(t[(k + 1) % 3]) - from);
            keep_above(stretch, glm::dot(inward, a - from), glm::dot(inward, b - from));
        }
        return stretch;
    }

    const WeldedMesh& mesh_;
    const std::vector<glm::dvec3>& normals_;
    const TriangleTrees& trees_;
    const SeamSurfaces& surfaces_;
    double diagonal_;
    double same_plane_; ///< how far apart faces of one plane may lie
    std::vector<std::uint32_t> near_;
};

/// The rest of an edge between seams, without parts shorter than `least`.
Stretches rest_of(const Stretches& seams, double least) {
    Stretches rest;
    double from = 0;
    for (const Stretch seam : seams) {
        if (seam.from - from >= least) rest.push_back({from, seam.from});
        from = seam.to;
    }
    if (1 - from >= least) rest.push_back({from, 1});
    return rest;
}

/// The seams among some of the edges.
struct SeamsOfPiece {
    std::vector<std::uint32_t> whole, cut;
    std::vector<EdgePart> left;
};

constexpr std::size_t edges_of_piece = 1024;

} // namespace

Seams find_seams(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                 const std::vector<glm::dvec3>& normals,
                 std::span<const std::optional<LineKind>> kinds, const TriangleTrees& trees,
                 const SeamSurfaces& surfaces, const std::vector<bool>& left_out) {
    const SeamFinder all{mesh, normals, trees, surfaces};
    const auto find = [&](std::size_t first, std::size_t end) {
        SeamFinder finder = all;
        SeamsOfPiece found;
        for (auto i = static_cast<std::uint32_t>(first); i < end; ++i) {
            const bool is_boundary = kinds[i] == LineKind::boundary && edges[i].face_count == 1;
            if (!is_boundary && kinds[i] != LineKind::crease) continue;
            if (!left_out.empty() && left_out[i]) continue;
            const Stretches stretches =
                is_boundary ? finder.of_boundary(edges[i]) : finder.of_crease(edges[i]);
            if (stretches.empty()) continue;
            const Stretches rest = rest_of(stretches, finder.least(edges[i]));
            (rest.empty() ? found.whole : found.cut).push_back(i);
            for (const Stretch part : rest) found.left.push_back({i, part.from, part.to});
        }
        return found;
    };
    Seams seams{.of_edge = std::vector<bool>(edges.size(), false), .left = {}, .cut = {}};
    for (const SeamsOfPiece& found :
         made_of_pieces<SeamsOfPiece>(edges.size(), edges_of_piece, find)) {
        for (const std::uint32_t i : found.whole) seams.of_edge[i] = true;
        seams.cut.insert(seams.cut.end(), found.cut.begin(), found.cut.end());
        seams.left.insert(seams.left.end(), found.left.begin(), found.left.end());
    }
    return seams;
}

} // namespace lineatlas
