#include "contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "base/vertex_sets.hpp"
#include "core/corner_normals.hpp"

namespace lineatlas {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::uint32_t least_faces = 64;
/// So many triangles show the shape of an undesigned surface.
constexpr std::uint32_t many_faces = 15'000;
constexpr double most_flat = 0.3; ///< share of a patch's faces that may be flat
/// Altitude as a share of a face's longest edge; half of all faces have more.
constexpr double least_altitude = 0.25;
constexpr double least_steadiness = 1.0 / 3;
constexpr double sharp_bend = 15 * degree;
constexpr double most_sharp = 0.1;      ///< of a patch's edges
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

    /// Finds the edges within patches with their two sides, and joins what lies beside them.
    void match_sides() {
        find_pairs();
        is_flat_.assign(faces_, false);
        for (std::size_t i = 0; i < in_.edges.size(); ++i) {
            const auto [a, b] = joins_[i];
            if (a == none) continue;
            if (in_.bends[i] < flat_bend) is_flat_[a / 3] = is_flat_[b / 3] = true;
            if (is_within(i) && vertex(a) != vertex(b) &&
                knows_normals(a / 3) == knows_normals(b / 3))
                join(a, b);
            else
                joins_[i] = {none, none};
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

    /// Whether the surface goes on across an edge.
    bool is_within(std::size_t edge) const {
        if (in_.bends[edge] > in_.most_bend) return false;
        const std::optional<LineKind>& kind = in_.kinds[edge];
        return kind ? *kind == LineKind::silhouette : in_.bends[edge] < flat_bend;
    }

    /// Joins the triangles and corners at two sides of an edge, which run against each other.
    void join(std::uint32_t a, std::uint32_t b) {
        patches_.unite(a / 3, b / 3);
        corners_.unite(a, next_corner(b));
        corners_.unite(next_corner(a), b);
    }

    void choose_patches(Silhouettes rule) {
        std::vector<std::uint32_t> count(faces_, 0), flat(faces_, 0), slivers(faces_, 0),
            known(faces_, 0);
        std::vector<std::uint32_t> edges(faces_, 0), sharp(faces_, 0);
        std::vector<bool> bends(faces_, false);
        for (std::uint32_t f = 0; f < faces_; ++f) {
            const std::uint32_t patch = patches_.find(f);
            ++count[patch];
            flat[patch] += is_flat_[f] ? 1 : 0;
            slivers[patch] += is_sliver(f) ? 1 : 0;
            known[patch] += knows_normals(f) ? 1 : 0;
        }
        for (std::size_t i = 0; i < in_.edges.size(); ++i) {
            if (joins_[i][0] == none) continue;
            const std::uint32_t patch = patches_.find(joins_[i][0] / 3);
            ++edges[patch];
            sharp[patch] += in_.bends[i] > sharp_bend ? 1 : 0;
            if (in_.bends[i] >= flat_bend) bends[patch] = true;
        }
        const bool by_shape = rule != Silhouettes::smooth && in_.corner_normals.empty();
        std::vector<std::uint32_t> undesigned(faces_, 0);
        if (by_shape)
            for (const std::uint32_t f : in_.undesigned) ++undesigned[patches_.find(f)];
        smooth_.assign(faces_, false);
        std::vector<bool> organic(faces_, false);
        for (std::uint32_t p = 0; p < faces_; ++p) {
            const bool exact = known[p] == count[p];
            const bool many = undesigned[p] == count[p] && count[p] >= many_faces;
            organic[p] = by_shape && !exact && !many && count[p] >= least_faces && is_of_solid(p) &&
                         flat[p] < most_flat * count[p] && 2 * slivers[p] < count[p] &&
                         sharp[p] < most_sharp * edges[p];
            smooth_[p] = bends[p] && (rule == Silhouettes::smooth || organic[p] || exact || many);
        }
        add_normals();
        if (std::ranges::find(organic, true) != organic.end()) keep_steady(organic);
    }

    /// Finds normals of corners: those of the file if it has them, else means of the normals of the
    /// triangles about the corner, weighted by their angles there. A tip, at which the file's
    /// normals do not agree, has none.
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

    /// Keeps only patches smooth that bend at a corner much as at the next. The bend at a corner is
    /// the mean sine by which edges fall away there, and it must correlate along edges. In noise it
    /// does not, and there interpolated normals do not describe the surface.
    void keep_steady(const std::vector<bool>& patches) {
        struct Bend {
            double sum = 0;
            std::uint32_t edges = 0;
            double mean() const { return edges > 0 ? sum / edges : 0; }
        };
        std::vector<Bend> of_corner(corners_size());
        const auto for_each_edge = [&](const auto& each) {
            for (const std::array<std::uint32_t, 2>& sides : joins_) {
                const std::uint32_t c = sides[0];
                if (c == none || !patches[patches_.find(c / 3)]) continue;
                each(patches_.find(c / 3), c, next_corner(c));
            }
        };
        for_each_edge([&](std::uint32_t, std::uint32_t a, std::uint32_t b) {
            const glm::dvec3 way = place(b) - place(a);
            const double length = glm::length(way);
            const auto add = [&](std::uint32_t corner, double sign) {
                const std::uint32_t set = corners_.find(corner);
                of_corner[set].sum += sign * glm::dot(normals_[set], way) / length;
                ++of_corner[set].edges;
            };
            add(a, -1);
            add(b, 1);
        });
        std::vector<double> products(faces_, 0), squares(faces_, 0);
        for_each_edge([&](std::uint32_t patch, std::uint32_t a, std::uint32_t b) {
            const double at_a = of_corner[corners_.find(a)].mean();
            const double at_b = of_corner[corners_.find(b)].mean();
            products[patch] += at_a * at_b;
            squares[patch] += (at_a * at_a + at_b * at_b) / 2;
        });
        for (std::uint32_t p = 0; p < faces_; ++p)
            if (patches[p] && products[p] < least_steadiness * squares[p]) smooth_[p] = false;
    }

    bool is_sliver(std::uint32_t face) const {
        double longest = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::dvec3 way = place(next_corner(3 * face + k)) - place(3 * face + k);
            longest = std::max(longest, glm::dot(way, way));
        }
        const glm::dvec3 twice_area = glm::cross(place(3 * face + 1) - place(3 * face),
                                                 place(3 * face + 2) - place(3 * face));
        return glm::length(twice_area) <= least_altitude * longest;
    }

    bool is_of_solid(std::uint32_t face) const {
        return in_.solid[in_.parts.of_vertex[in_.mesh.triangles[face].x]];
    }

    /// Whether the file has normals at all corners of a face, except at a tip.
    bool knows_normals(std::uint32_t face) const {
        for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner)
            if (known_normal(corner) != glm::dvec3{0}) return true;
        return false;
    }

    bool is_smooth(std::uint32_t face) { return smooth_[patches_.find(face)]; }

    /// The file's normal at a corner; zero if it has none.
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
    std::vector<bool> is_flat_;                       ///< triangles
    std::vector<bool> smooth_;                        ///< patches
    std::vector<glm::dvec3> normals_;                 ///< of corners, by their sets
    std::vector<std::uint32_t> number_;               ///< of corners, in Contours::corners
    std::vector<std::uint32_t> edge_of_side_;         ///< as in Contours::faces
};

/// Whether any patch may be smooth by Silhouettes::automatic. Few models that were designed as
/// meshes have such patches, and finding patches takes more memory than all other steps. The test
/// is weaker than that of choose_patches(), because edges have other faces in place of slivers.
bool may_be_organic(const ContourInput& in) {
    const std::vector<bool> is_flat = flat_faces(in.mesh.triangles.size(), in.edges, in.bends);
    std::vector<std::uint32_t> bent(in.parts.count, 0);
    for (std::size_t face = 0; face < is_flat.size(); ++face) {
        const std::uint32_t part = in.parts.of_vertex[in.mesh.triangles[face].x];
        if (!is_flat[face] && in.solid[part]) ++bent[part];
    }
    return std::ranges::any_of(bent, [](std::uint32_t n) { return n >= least_faces / 2; });
}

} // namespace

FoundContours find_contours(const ContourInput& input, Silhouettes rule) {
    const bool by_shape = rule == Silhouettes::automatic && input.corner_normals.empty();
    if (by_shape && input.undesigned.empty() && !may_be_organic(input)) return {};
    return ContourFinder{input}.find(rule);
}

} // namespace lineatlas
