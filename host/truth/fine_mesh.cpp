#include "fine_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/first_seen.hpp"
#include "core/pair_key.hpp"
#include "polygon/polygon.hpp"
#include "surface_triangle.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t most_parts = 10;
constexpr double most_triangles = 250'000; ///< of triangles with surfaces after division

/// The place of an ellipse in the direction of a point beside it.
glm::dvec3 on_curve(const EdgeCurve& curve, const glm::dvec3& point) {
    const glm::dvec3 way = point - curve.center;
    const double angle = std::atan2(glm::dot(way, curve.v) / glm::dot(curve.v, curve.v),
                                    glm::dot(way, curve.u) / glm::dot(curve.u, curve.u));
    return curve.center + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
}

class Divider {
  public:
    Divider(const Mesh& mesh, std::uint32_t parts) : mesh_(mesh), parts_(parts), fine_(mesh) {
        fine_.triangles.clear();
        fine_.triangle_group.clear();
        fine_.triangle_object.clear();
        fine_.known_edges.clear();
        fine_.corner_normals.clear();
        fine_.surfaces.of_triangle.clear();
        fine_.surfaces.parameters.clear();
        fine_.precision = mesh.precision / static_cast<float>(parts * parts);
        find_places();
    }

    Mesh divide() {
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i)
            if (has_surface(i))
                for (int k = 0; k < 3; ++k) divide_side(i, k);
        place_sides();
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (has_surface(i))
                add_curved(i);
            else
                add_flat(i);
        }
        for (const KnownEdge& edge : mesh_.known_edges) add_known(edge);
        return std::move(fine_);
    }

  private:
    /// The places that divide an edge of triangles, from the end with the lower number in place_of_
    /// on.
    struct Side {
        std::uint32_t first; ///< in fine_.positions, and in sums_ beyond the mesh's own positions
        std::uint32_t faces; ///< number of faces whose mean the places are
    };

    bool has_surface(std::uint32_t triangle) const {
        return mesh_.surfaces.of_triangle[triangle] != KnownSurfaces::none;
    }

    SurfaceTriangle on_surface(std::uint32_t triangle) const {
        const glm::uvec3 t = mesh_.triangles[triangle];
        return {mesh_.surfaces,
                triangle,
                {mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z]}};
    }

    /// Gives equal positions one place, the first of them.
    void find_places() {
        FirstSeen table{mesh_.positions.size()};
        place_of_.reserve(mesh_.positions.size());
        for (std::uint32_t i = 0; i < mesh_.positions.size(); ++i) {
            const glm::vec3 at = mesh_.positions[i];
            place_of_.push_back(table.find_or_add(
                i, hash_of(at), [&](std::uint32_t known) { return mesh_.positions[known] == at; }));
        }
    }

    std::uint64_t key_of(std::uint32_t from, std::uint32_t to) const {
        return pair_key(place_of_[from], place_of_[to]);
    }

    void divide_side(std::uint32_t triangle, int k) {
        const glm::uvec3 corners = mesh_.triangles[triangle];
        int from = k, to = (k + 1) % 3;
        if (place_of_[corners[from]] > place_of_[corners[to]]) std::swap(from, to);
        const auto first = static_cast<std::uint32_t>(fine_.positions.size());
        const auto [side, fresh] =
            sides_.try_emplace(key_of(corners[from], corners[to]), Side{first, 0});
        if (fresh) {
            fine_.positions.resize(first + parts_ - 1);
            sums_.resize(sums_.size() + parts_ - 1, glm::dvec3{0});
        }
        ++side->second.faces;
        const SurfaceTriangle patch = on_surface(triangle);
        for (std::uint32_t i = 1; i < parts_; ++i) {
            glm::dvec3 shares{0};
            shares[to] = static_cast<double>(i) / parts_;
            shares[from] = 1 - shares[to];
            sum(side->second, i) += patch.place(shares).at;
        }
    }

    glm::dvec3& sum(const Side& side, std::uint32_t i) {
        return sums_[side.first + i - 1 - mesh_.positions.size()];
    }

    /// Puts places of sides on the edge's curve if the file knows it. Cuts of sections stay
    /// straight between corners, because surfaces leave the plane of the cut there.
    void place_sides() {
        for (auto& [key, side] : sides_)
            for (std::uint32_t i = 1; i < parts_; ++i) sum(side, i) /= side.faces;
        for (const KnownEdge& edge : mesh_.known_edges) {
            const auto side = sides_.find(key_of(edge.from, edge.to));
            if (side == sides_.end() || edge.edge >= mesh_.edge_curves.size()) continue;
            const std::optional<EdgeCurve>& curve = mesh_.edge_curves[edge.edge];
            if (!curve) continue;
            for (std::uint32_t i = 1; i < parts_; ++i)
                sum(side->second, i) = on_curve(*curve, sum(side->second, i));
        }
        for (const std::vector<std::uint32_t>& polyline : mesh_.polylines)
            for (std::size_t i = 1; i < polyline.size(); ++i)
                place_straight(polyline[i - 1], polyline[i]);
        for (std::size_t i = 0; i < sums_.size(); ++i)
            fine_.positions[mesh_.positions.size() + i] = glm::vec3{sums_[i]};
    }

    void place_straight(std::uint32_t from, std::uint32_t to) {
        const auto side = sides_.find(key_of(from, to));
        if (side == sides_.end()) return;
        if (place_of_[from] > place_of_[to]) std::swap(from, to);
        for (std::uint32_t i = 1; i < parts_; ++i)
            sum(side->second, i) =
                glm::mix(glm::dvec3{mesh_.positions[from]}, glm::dvec3{mesh_.positions[to]},
                         static_cast<double>(i) / parts_);
    }

    /// The place `i` parts from one end of a divided side to the other.
    std::uint32_t side_position(std::uint32_t from, std::uint32_t to, std::uint32_t i) const {
        const std::uint32_t first = sides_.at(key_of(from, to)).first;
        return first + (place_of_[from] < place_of_[to] ? i : parts_ - i) - 1;
    }

    void add_triangle(std::uint32_t source, const glm::uvec3& corners) {
        fine_.triangles.push_back(corners);
        if (!mesh_.triangle_group.empty())
            fine_.triangle_group.push_back(mesh_.triangle_group[source]);
        if (!mesh_.triangle_object.empty())
            fine_.triangle_object.push_back(mesh_.triangle_object[source]);
    }

    void add_normal(const glm::dvec3& normal) {
        if (!mesh_.corner_normals.empty()) fine_.corner_normals.emplace_back(normal);
    }

    void add_curved(std::uint32_t triangle) {
        const glm::uvec3 corners = mesh_.triangles[triangle];
        const SurfaceTriangle patch = on_surface(triangle);
        struct Node {
            std::uint32_t position;
            glm::dvec2 parameters;
            glm::dvec3 normal;
        };
        std::vector<Node> nodes; // row by row from the side of corners 0 and 1 to corner 2
        std::vector<std::size_t> rows;
        for (std::uint32_t row = 0; row <= parts_; ++row) {
            rows.push_back(nodes.size());
            for (std::uint32_t i = 0; i + row <= parts_; ++i) {
                const std::uint32_t rest = parts_ - row - i;
                const glm::dvec3 shares = glm::dvec3{rest, i, row} / static_cast<double>(parts_);
                const SurfaceTriangle::Place place = patch.place(shares);
                Node node{
                    .position = 0, .parameters = patch.parameters(shares), .normal = place.normal};
                if (rest == parts_)
                    node.position = corners.x;
                else if (i == parts_)
                    node.position = corners.y;
                else if (row == parts_)
                    node.position = corners.z;
                else if (row == 0)
                    node.position = side_position(corners.x, corners.y, i);
                else if (rest == 0)
                    node.position = side_position(corners.y, corners.z, row);
                else if (i == 0)
                    node.position = side_position(corners.x, corners.z, row);
                else {
                    node.position = static_cast<std::uint32_t>(fine_.positions.size());
                    fine_.positions.emplace_back(place.at);
                }
                nodes.push_back(node);
            }
        }
        const std::uint32_t surface = mesh_.surfaces.of_triangle[triangle];
        const auto add = [&](const Node& a, const Node& b, const Node& c) {
            add_triangle(triangle, {a.position, b.position, c.position});
            fine_.surfaces.add_triangle(surface, {a.parameters, b.parameters, c.parameters});
            for (const Node* node : {&a, &b, &c}) add_normal(node->normal);
        };
        for (std::uint32_t row = 0; row < parts_; ++row) {
            for (std::uint32_t i = 0; i + row < parts_; ++i) {
                const Node *low = &nodes[rows[row] + i], *high = &nodes[rows[row + 1] + i];
                add(low[0], low[1], high[0]);
                if (i + row + 1 < parts_) add(low[1], high[1], high[0]);
            }
        }
    }

    /// A triangle without a surface keeps its corners, and gets those of sides that others divide.
    void add_flat(std::uint32_t triangle) {
        const glm::uvec3 corners = mesh_.triangles[triangle];
        std::vector<std::uint32_t> outline;
        std::vector<glm::dvec3> normals;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
            const bool divided = sides_.contains(key_of(from, to));
            for (std::uint32_t i = 0; i < (divided ? parts_ : 1); ++i) {
                outline.push_back(i == 0 ? from : side_position(from, to, i));
                if (mesh_.corner_normals.empty()) continue;
                const std::size_t first = std::size_t{3} * triangle;
                normals.push_back(glm::mix(
                    glm::dvec3{mesh_.corner_normals[first + static_cast<std::size_t>(k)]},
                    glm::dvec3{mesh_.corner_normals[first + static_cast<std::size_t>((k + 1) % 3)]},
                    static_cast<double>(i) / parts_));
            }
        }
        std::vector<glm::uvec3> pieces{corners};
        if (outline.size() > 3) {
            pieces.clear();
            triangulate(fine_.positions, outline, pieces);
        }
        for (const glm::uvec3& piece : pieces) {
            add_triangle(triangle, piece);
            fine_.surfaces.add_triangle(KnownSurfaces::none, {});
            for (int k = 0; k < 3 && !normals.empty(); ++k)
                add_normal(normals[static_cast<std::size_t>(std::ranges::find(outline, piece[k]) -
                                                            outline.begin())]);
        }
    }

    void add_known(const KnownEdge& edge) {
        if (!sides_.contains(key_of(edge.from, edge.to))) {
            fine_.known_edges.push_back(edge);
            return;
        }
        KnownEdge piece = edge;
        for (std::uint32_t i = 1; i <= parts_; ++i) {
            piece.to = i == parts_ ? edge.to : side_position(edge.from, edge.to, i);
            fine_.known_edges.push_back(piece);
            piece.from = piece.to;
        }
    }

    const Mesh& mesh_;
    std::uint32_t parts_;
    Mesh fine_;
    std::vector<std::uint32_t> place_of_; ///< per position
    std::unordered_map<std::uint64_t, Side> sides_;
    std::vector<glm::dvec3> sums_;
};

} // namespace

std::uint32_t fine_parts(const Mesh& mesh) {
    const auto flat = std::ranges::count(mesh.surfaces.of_triangle, KnownSurfaces::none);
    const std::size_t curved = mesh.surfaces.of_triangle.size() - static_cast<std::size_t>(flat);
    if (curved == 0) return 1;
    const double parts = std::sqrt(most_triangles / static_cast<double>(curved));
    return static_cast<std::uint32_t>(std::clamp(parts, 2.0, double{most_parts}));
}

Mesh fine_mesh(const Mesh& mesh, std::uint32_t parts) {
    return parts > 1 && !mesh.surfaces.empty() ? Divider{mesh, parts}.divide() : mesh;
}

} // namespace lineatlas
