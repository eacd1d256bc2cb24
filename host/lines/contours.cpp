#include "contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numeric>

#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "base/vertex_sets.hpp"
#include "core/corner_normals.hpp"

namespace lineatlas {
namespace {

constexpr double tip_agreement = 0.999; ///< of normals about a corner, by their mean's length

/// A side of a triangle, from corner k to the next, kept at the smaller of its two vertices.
struct Side {
    std::uint32_t other;  ///< the larger vertex
    std::uint32_t corner; ///< 3 triangle + k
    auto operator<=>(const Side&) const = default;
};

class ContourFinder {
  public:
    explicit ContourFinder(const ContourInput& input)
        : in_(input), faces_(input.mesh.triangles.size()), patches_(faces_), corners_(3 * faces_),
          edge_of_side_(3 * faces_, none) {}

    FoundContours find(Silhouettes rule) {
        match_sides();
        choose_patches(rule);
        FoundContours found;
        found.replaces.assign(in_.edges.size(), false);
        for (std::size_t i = 0; i < in_.edges.size(); ++i)
            found.replaces[i] = joins_[i][0] != none && is_smooth(joins_[i][0] / 3);
        add_corners(found.contours);
        add_faces(found);
        return found;
    }

  private:
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::uint32_t vertex(std::uint32_t corner) const {
        return in_.mesh.triangles[corner / 3][static_cast<int>(corner % 3)];
    }
    glm::dvec3 place(std::uint32_t corner) const {
        return glm::dvec3{in_.mesh.vertices[vertex(corner)]};
    }

    /// Edges within a patch: their two sides, and what that joins.
    void match_sides() {
        find_pairs();
        bends_.assign(faces_, false);
        for (std::size_t i = 0; i < in_.edges.size(); ++i) {
            const auto [a, b] = joins_[i];
            if (a == none) continue;
            if (is_within(i) && vertex(a) != vertex(b) &&
                knows_normals(a / 3) == knows_normals(b / 3)) {
                join(a, b);
                if (in_.bends[i] >= flat_bend) bends_[a / 3] = true;
            } else {
                joins_[i] = {none, none};
            }
        }
    }

    /// The sides of edges that have two.
    void find_pairs() {
        const std::size_t vertices = in_.mesh.vertices.size();
        Groups<Side> sides{
            vertices, corners_size(), [&](std::size_t i, const auto& add) {
                const auto c = static_cast<std::uint32_t>(i);
                const auto [from, to] = std::minmax({vertex(c), vertex(next_corner(c))});
                add(from, Side{to, c});
            }};
        const std::vector<std::uint32_t> first = first_edges(vertices, in_.edges);
        joins_.assign(in_.edges.size(), {none, none});
        for_each_index(vertices, [&](std::size_t v) {
            const std::span<Side> own = sides[v];
            std::ranges::sort(own);
            auto side = own.begin();
            for (std::uint32_t i = first[v]; i < first[v + 1]; ++i) {
                const std::uint32_t other = std::max(in_.edges[i].p, in_.edges[i].q);
                side = std::find_if(side, own.end(), [&](Side s) { return s.other >= other; });
                const auto end =
                    std::find_if(side, own.end(), [&](Side s) { return s.other != other; });
                if (end - side == 2) joins_[i] = {side[0].corner, side[1].corner};
                side = end;
            }
        });
    }

    /// Whether the surface goes on across it.
    bool is_within(std::size_t edge) const {
        if (in_.bends[edge] > in_.most_bend) return false;
        const std::optional<LineKind>& kind = in_.kinds[edge];
        return kind ? *kind == LineKind::silhouette : in_.bends[edge] < flat_bend;
    }

    /// Two sides of an edge, which run against each other.
    void join(std::uint32_t a, std::uint32_t b) {
        patches_.unite(a / 3, b / 3);
        corners_.unite(a, next_corner(b));
        corners_.unite(next_corner(a), b);
    }

    void choose_patches(Silhouettes rule) {
        std::vector<std::uint32_t> count(faces_, 0), known(faces_, 0);
        for (std::uint32_t f = 0; f < faces_; ++f) {
            ++count[patches_.find(f)];
            known[patches_.find(f)] += knows_normals(f) ? 1 : 0;
        }
        smooth_.assign(faces_, false);
        const auto choose = [&](std::uint32_t face) {
            const std::uint32_t patch = patches_.find(face);
            if (bends_[face]) smooth_[patch] = true;
        };
        for (std::uint32_t f = 0; f < faces_; ++f)
            if (rule == Silhouettes::smooth || known[patches_.find(f)] == count[patches_.find(f)])
                choose(f);
        if (in_.corner_normals.empty())
            for (const std::uint32_t f : in_.undesigned) choose(f);
        add_normals();
    }

    /// Normals of corners: the surface's own where the file has them, else those of the triangles
    /// about them, by the angles that they have there. A tip, about which the surface's own do not
    /// agree, has none.
    void add_normals() {
        normals_.assign(corners_size(), glm::dvec3{0});
        std::vector<double> known_angles(corners_size(), 0);
        for (std::uint32_t c = 0; c < corners_size(); ++c) {
            if (!is_smooth(c / 3)) continue;
            const std::uint32_t next = next_corner(c), last = next_corner(next);
            const glm::dvec3 normal =
                normal_by_angle(place(next) - place(c), place(last) - place(c), known_normal(c));
            const std::uint32_t set = corners_.find(c);
            normals_[set] += normal;
            if (knows_normals(c / 3)) known_angles[set] += glm::length(normal);
        }
        for (std::uint32_t set = 0; set < corners_size(); ++set) {
            glm::dvec3& normal = normals_[set];
            const double length = glm::length(normal);
            if (length < tip_agreement * known_angles[set])
                normal = glm::dvec3{0};
            else if (length > 0)
                normal /= length;
        }
    }

    /// Whether the file says of a face where its surface looks, but for a tip.
    bool knows_normals(std::uint32_t face) const {
        for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner)
            if (known_normal(corner) != glm::dvec3{0}) return true;
        return false;
    }

    bool is_smooth(std::uint32_t face) { return smooth_[patches_.find(face)]; }

    /// What the file says of the surface at a corner; zero where it says nothing.
    glm::dvec3 known_normal(std::uint32_t corner) const {
        if (in_.corner_normals.empty()) return glm::dvec3{0};
        return glm::dvec3{
            in_.corner_normals[3 * in_.mesh.triangle_source[corner / 3] + corner % 3]};
    }

    void add_corners(Contours& contours) {
        number_.assign(corners_size(), none);
        for (std::uint32_t c = 0; c < corners_size(); ++c) {
            if (!is_smooth(c / 3)) continue;
            const std::uint32_t set = corners_.find(c);
            if (number_[set] == none) {
                const glm::vec3 n{normals_[set]};
                number_[set] = static_cast<std::uint32_t>(contours.corners.size());
                contours.corners.push_back({.vertex = vertex(c), .normal = {n.x, n.y, n.z}});
            }
            number_[c] = number_[set];
        }
    }

    void add_faces(FoundContours& found) {
        std::vector<glm::uvec2>& edges = found.contours.edges;
        const auto add_edge = [&](std::uint32_t side) {
            edge_of_side_[side] = static_cast<std::uint32_t>(edges.size());
            edges.emplace_back(number_[side], number_[next_corner(side)]);
        };
        for (const std::array<std::uint32_t, 2>& sides : joins_) {
            if (sides[0] == none || !is_smooth(sides[0] / 3)) continue;
            add_edge(sides[0]);
            edge_of_side_[sides[1]] = edge_of_side_[sides[0]] | LA_CONTOUR_TURNED;
        }
        for (std::uint32_t f = 0; f < faces_; ++f) {
            if (!is_smooth(f)) continue;
            glm::uvec3 face{};
            for (std::uint32_t k = 0; k < 3; ++k) {
                if (edge_of_side_[3 * f + k] == none) add_edge(3 * f + k);
                face[static_cast<int>(k)] = edge_of_side_[3 * f + k];
            }
            found.contours.faces.push_back(face);
            found.faces.push_back(f);
        }
    }

    std::uint32_t corners_size() const { return 3 * faces_; }

    const ContourInput& in_;
    std::uint32_t faces_;
    VertexSets patches_;                              ///< of triangles
    VertexSets corners_;                              ///< of corners, which have a normal in common
    std::vector<std::array<std::uint32_t, 2>> joins_; ///< per edge its sides, or none
    std::vector<bool> bends_;                         ///< triangles, to a neighbour
    std::vector<bool> smooth_;                        ///< patches
    std::vector<glm::dvec3> normals_;                 ///< of corners, by their sets
    std::vector<std::uint32_t> number_;               ///< of corners, in Contours::corners
    std::vector<std::uint32_t> edge_of_side_;         ///< as in Contours::faces
};

} // namespace

FoundContours find_contours(const ContourInput& input, Silhouettes rule) {
    const bool by_shape = rule == Silhouettes::automatic && input.corner_normals.empty();
    if (by_shape && input.undesigned.empty()) return {};
    return ContourFinder{input}.find(rule);
}

} // namespace lineatlas
