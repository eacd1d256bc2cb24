#include "intersections.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/first_seen.hpp"
#include "base/parallel.hpp"
#include "base/stretches.hpp"
#include "core/chain.hpp"
#include "core/contact.hpp"

namespace lineatlas {
namespace {

constexpr double coplanar = 2 * 0.017453292519943295; ///< radians
const double coplanar_cosine = std::cos(coplanar);
/// Round parts that fit each other cut each other at less than this angle where their facets do not
/// match.
const double shallow_cosine = std::cos(15 * 0.017453292519943295);

// Shares of the model's diagonal.
constexpr double shallow = 3e-4; ///< two faces less deep in each other only touch at a small angle
constexpr double same_place = 1e-6; ///< of ends of intersections
constexpr double shortest = 2e-7;   ///< of an intersection
constexpr double doubled = 1e-3;    ///< lines this near are one

const double along_cosine = std::cos(15 * 0.017453292519943295); ///< of lines along each other
constexpr double most_free = 0.3; ///< share of an intersection with no line beside it

using Heights = std::array<double, 3>; ///< of a triangle's corners over a plane

class Crossing {
  public:
    Crossing(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals, double diagonal)
        : mesh_(mesh), normals_(normals), diagonal_(diagonal),
          contact_(contact_of(diagonal_, mesh.precision)) {}

    /// Adds the intersection of two triangles.
    void operator()(std::uint32_t a, std::uint32_t b) {
        const glm::dvec3 normal_a = normals_[a], normal_b = normals_[b];
        if (normal_a == glm::dvec3{0} || normal_b == glm::dvec3{0}) return;
        const double cosine = std::abs(glm::dot(normal_a, normal_b));
        if (cosine > coplanar_cosine) return;
        const Heights heights_a = heights(a, b);
        if (!passes(heights_a)) {
            if (lies_with_an_edge(heights_a) && passes(heights(b, a))) keep_lying(a, b, heights_a);
            return;
        }
        const Heights heights_b = heights(b, a);
        if (!passes(heights_b)) {
            if (lies_with_an_edge(heights_b)) keep_lying(b, a, heights_b);
            return;
        }
        if (is_shallow(cosine, depth(heights_a), heights_b)) return;
        add(a, heights_a, b, heights_b);
    }

    /// Appends the intersections of another object.
    void append(const Crossing& other) {
        found_.insert(found_.end(), other.found_.begin(), other.found_.end());
        lying_.insert(lying_.end(), other.lying_.begin(), other.lying_.end());
    }

    /// All intersections so far.
    std::vector<Intersection> take() {
        join_lying();
        return std::move(found_);
    }

  private:
    /// A place where a triangle's edge meets the plane of the other triangle.
    struct End {
        EdgePlace place{};
        double at = 0; ///< along the line that both planes share
    };
    struct Chord {
        End first, last;
    };

    /// A triangle on one side of another's plane, with an edge in the plane. Together with the
    /// triangle beyond that edge it passes through the plane if that triangle is on the other side.
    struct Lying {
        std::uint32_t p, q; ///< the edge's vertices, p < q
        std::uint32_t plane, face;
        double height; ///< of the third corner
    };

    glm::dvec3 at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }

    static bool lies_with_an_edge(const Heights& h) { return std::ranges::count(h, 0.0) == 2; }

    void keep_lying(std::uint32_t face, std::uint32_t plane, const Heights& heights) {
        const int apex = heights[0] != 0 ? 0 : heights[1] != 0 ? 1 : 2;
        const glm::uvec3 t = mesh_.triangles[face];
        const auto [p, q] = std::minmax(t[(apex + 1) % 3], t[(apex + 2) % 3]);
        lying_.push_back({p, q, plane, face, heights[apex]});
    }

    void join_lying() {
        std::ranges::sort(lying_, {}, [](const Lying& l) {
            return std::tuple{l.p, l.q, l.plane, l.height, l.face};
        });
        for (auto first = lying_.begin(); first != lying_.end();) {
            const auto end = std::find_if(first, lying_.end(), [&](const Lying& l) {
                return l.p != first->p || l.q != first->q || l.plane != first->plane;
            });
            if (first->height < 0 && (end - 1)->height > 0) add_through(*first, *(end - 1));
            first = end;
        }
    }

    void add_through(const Lying& below, const Lying& above) {
        const std::uint32_t face = above.face, plane = above.plane;
        Heights sides{}; // as if the triangle reached equally far below
        const glm::uvec3 t = mesh_.triangles[face];
        for (int k = 0; k < 3; ++k) sides[k] = t[k] == above.p || t[k] == above.q ? 0 : 1;
        const Heights heights_plane = heights(plane, face);
        const double cosine = std::abs(glm::dot(normals_[face], normals_[plane]));
        if (is_shallow(cosine, std::min(-below.height, above.height), heights_plane)) return;
        add(face, sides, plane, heights_plane);
    }

    bool is_shallow(double cosine, double depth_a, const Heights& heights_b) const {
        return cosine > shallow_cosine && std::max(depth_a, depth(heights_b)) < shallow * diagonal_;
    }

    void add(std::uint32_t a, const Heights& heights_a, std::uint32_t b, const Heights& heights_b) {
        const glm::dvec3 along = glm::normalize(glm::cross(normals_[a], normals_[b]));
        const Chord of_a = chord(a, heights_a, along), of_b = chord(b, heights_b, along);
        const End& first = of_a.first.at > of_b.first.at ? of_a.first : of_b.first;
        const End& last = of_a.last.at < of_b.last.at ? of_a.last : of_b.last;
        if (!(last.at - first.at > shortest * diagonal_)) return;
        found_.push_back({first.place, last.place, std::min(a, b), std::max(a, b)});
    }

    /// A corner's height depends on the corner and the plane alone, so that triangles that share an
    /// edge agree on where it meets a plane.
    Heights heights(std::uint32_t face, std::uint32_t plane) const {
        const glm::dvec3 origin = at(mesh_.triangles[plane].x);
        Heights result{};
        for (int k = 0; k < 3; ++k) {
            const double height = glm::dot(normals_[plane], at(mesh_.triangles[face][k]) - origin);
            result[k] = std::abs(height) < contact_ ? 0 : height;
        }
        return result;
    }

    static bool passes(const Heights& h) {
        return std::min({h[0], h[1], h[2]}) < 0 && std::max({h[0], h[1], h[2]}) > 0;
    }

    /// How far a triangle reaches through the plane.
    static double depth(const Heights& h) {
        return std::min(-std::min({h[0], h[1], h[2]}), std::max({h[0], h[1], h[2]}));
    }

    Chord chord(std::uint32_t face, const Heights& heights, glm::dvec3 along) const {
        const glm::uvec3 t = mesh_.triangles[face];
        std::array<End, 2> ends;
        int count = 0;
        for (int k = 0; k < 3 && count < 2; ++k) {
            int low = k, high = (k + 1) % 3;
            if ((heights[low] > 0) == (heights[high] > 0)) continue;
            if (t[low] > t[high]) std::swap(low, high);
            const double share = heights[low] / (heights[low] - heights[high]);
            const glm::dvec3 from = at(t[low]), to = at(t[high]);
            ends[count++] = {{t[low], t[high], share}, glm::dot(from + (to - from) * share, along)};
        }
        if (ends[0].at > ends[1].at) std::swap(ends[0], ends[1]);
        return {ends[0], ends[1]};
    }

    const WeldedMesh& mesh_;
    const std::vector<glm::dvec3>& normals_;
    double diagonal_;
    double contact_; ///< points no deeper behind a face only touch it
    std::vector<Intersection> found_;
    std::vector<Lying> lying_;
};

/// Merges places that are almost equal. Where an edge passes through an edge, it meets two planes
/// at places that differ by rounding. Chains would end there.
class NearPlaces {
  public:
    NearPlaces(const WeldedMesh& mesh, double diagonal, std::size_t most)
        : mesh_(mesh), cell_(same_place * diagonal), table_(most),
          marked_(std::bit_ceil(bits_per_place * (most + 2)), false) {}

    void join(std::vector<Intersection>& intersections) {
        for (Intersection& one : intersections) {
            one.p = first_near(one.p);
            one.q = first_near(one.q);
        }
        std::erase_if(intersections, [](const Intersection& one) { return one.p == one.q; });
    }

  private:
    using Cell = std::array<std::int64_t, 3>;
    struct Known {
        Cell cell;
        EdgePlace place;
        glm::dvec3 at;
    };

    static std::uint64_t hash_of_cell(const Cell& cell) {
        std::uint64_t hash = 0;
        for (const std::int64_t index : cell) {
            hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9E3779B97F4A7C15ULL;
            hash ^= hash >> 29U;
        }
        return hash;
    }

    auto is_of(const Cell& cell) const {
        return [this, &cell](std::uint32_t index) { return known_[index].cell == cell; };
    }

    EdgePlace first_near(const EdgePlace& place) {
        const glm::dvec3 from{mesh_.vertices[place.from]}, to{mesh_.vertices[place.to]};
        const glm::dvec3 at = from + (to - from) * place.share;
        const glm::dvec3 scaled = glm::floor(at / cell_);
        const Cell cell{static_cast<std::int64_t>(scaled.x), static_cast<std::int64_t>(scaled.y),
                        static_cast<std::int64_t>(scaled.z)};
        for (std::int64_t i = 0; i < 27; ++i) {
            const Cell beside{cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1};
            const std::uint64_t hash = hash_of_cell(beside);
            if (!marked_[bit_of(hash)]) continue;
            const auto known = table_.find(static_cast<std::uint32_t>(hash), is_of(beside));
            if (known && glm::distance(known_[*known].at, at) < cell_) return known_[*known].place;
        }
        add({cell, place, at});
        return place;
    }

    void add(const Known& known) {
        const std::uint64_t hash = hash_of_cell(known.cell);
        const auto fresh = static_cast<std::uint32_t>(known_.size());
        if (table_.find_or_add(fresh, static_cast<std::uint32_t>(hash), is_of(known.cell)) == fresh)
            known_.push_back(known);
        marked_[bit_of(hash)] = true;
    }

    /// Most cells around a place are empty. A bit tells so faster than the table, which would cost
    /// an access to memory.
    std::size_t bit_of(std::uint64_t hash) const { return hash >> 8U & (marked_.size() - 1); }

    const WeldedMesh& mesh_;
    double cell_;
    std::vector<Known> known_;
    FirstSeen table_; ///< of cells in `known_`
    static constexpr std::size_t bits_per_place = 16;
    std::vector<bool> marked_; ///< by hash, cells that are in `known_`
};

class Doubles {
  public:
    Doubles(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
            std::span<const DrawnLine> lines, double diagonal)
        : mesh_(mesh), normals_(normals), lines_(lines), diagonal_(diagonal),
          contact_(contact_of(diagonal_, mesh.precision)), tree_(boxes(mesh, lines)) {}

    /// Whether each intersection is doubled by a line.
    std::vector<bool> find(std::span<const Intersection> intersections) const {
        constexpr std::size_t piece = 256;
        const auto find = [&](std::size_t first, std::size_t end) {
            std::vector<Stretch> stretches;
            std::vector<char> is_double;
            for (std::size_t i = first; i < end; ++i)
                is_double.push_back(has(intersections[i], stretches));
            return is_double;
        };
        const std::vector<char> all =
            joined(made_of_pieces<std::vector<char>>(intersections.size(), piece, find));
        return {all.begin(), all.end()};
    }

  private:
    /// `stretches`: a buffer.
    bool has(const Intersection& one, std::vector<Stretch>& stretches) const {
        const glm::dvec3 p = place(one.p), way = place(one.q) - p;
        const double length = glm::length(way);
        if (length == 0) return true;
        const glm::dvec3 along = way / length;
        const auto reach = static_cast<float>(doubled * diagonal_);
        const glm::vec3 start{p}, end{p + way};
        stretches.clear();
        tree_.visit_meeting(
            {glm::min(start, end) - reach, glm::max(start, end) + reach},
            [&](std::uint32_t line) { add_beside(line, one, p, along, length, stretches); });
        return free_length(length, stretches) <= most_free * length;
    }

    static std::vector<Bounds> boxes(const WeldedMesh& mesh, std::span<const DrawnLine> lines) {
        std::vector<Bounds> result(lines.size());
        for_each_index(lines.size(), [&](std::size_t i) {
            const glm::vec3 p = mesh.vertices[lines[i].p], q = mesh.vertices[lines[i].q];
            result[i] = {glm::min(p, q), glm::max(p, q)};
        });
        return result;
    }

    glm::dvec3 at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }
    glm::dvec3 place(const EdgePlace& place) const {
        return at(place.from) + (at(place.to) - at(place.from)) * place.share;
    }

    /// The part of the intersection that runs beside a line.
    void add_beside(std::uint32_t index, const Intersection& one, glm::dvec3 p, glm::dvec3 along,
                    double length, std::vector<Stretch>& stretches) const {
        const glm::dvec3 start = at(lines_[index].p), way = at(lines_[index].q) - start;
        const double line_length = glm::length(way);
        if (line_length == 0) return;
        const glm::dvec3 direction = way / line_length;
        const double cosine = glm::dot(along, direction);
        if (std::abs(cosine) < along_cosine) return;
        // Between the line's ends.
        const double at_start = glm::dot(start - p, direction) / cosine;
        const double at_end = at_start + line_length / cosine;
        Stretch stretch{std::max(0.0, std::min(at_start, at_end)),
                        std::min(length, std::max(at_start, at_end))};
        // Within reach of the line: the distance is the square root of a + 2 b s + c s^2.
        const glm::dvec3 apart = p - start - direction * glm::dot(p - start, direction);
        const glm::dvec3 opening = along - direction * cosine;
        const double reach = doubled * diagonal_;
        const double a = glm::dot(apart, apart) - reach * reach;
        const double b = glm::dot(apart, opening), c = glm::dot(opening, opening);
        if (c > 1e-12) {
            const double root = b * b - a * c;
            if (root <= 0) return;
            stretch.from = std::max(stretch.from, (-b - std::sqrt(root)) / c);
            stretch.to = std::min(stretch.to, (-b + std::sqrt(root)) / c);
        } else if (a > 0) {
            return;
        }
        if (!(stretch.from < stretch.to)) return;
        const glm::dvec3 middle = p + along * (0.5 * (stretch.from + stretch.to));
        const glm::dvec3 beside = start + direction * glm::dot(middle - start, direction);
        if (is_behind(one.face_a, beside) || is_behind(one.face_b, beside)) return;
        stretches.push_back(stretch);
    }

    bool is_behind(std::uint32_t face, glm::dvec3 point) const {
        return glm::dot(normals_[face], point - at(mesh_.triangles[face].x)) < -contact_;
    }

    static double free_length(double length, std::vector<Stretch>& stretches) {
        std::ranges::sort(stretches, {}, &Stretch::from);
        double free = 0, reached = 0;
        for (const Stretch stretch : stretches) {
            free += std::max(0.0, stretch.from - reached);
            reached = std::max(reached, stretch.to);
        }
        return free + std::max(0.0, length - reached);
    }

    const WeldedMesh& mesh_;
    const std::vector<glm::dvec3>& normals_;
    std::span<const DrawnLine> lines_;
    double diagonal_, contact_;
    BoxTree tree_;
};

/// Decides about doubled lines by chains. A line that is doubled in some places would be left as
/// crumbs between them. So the larger part of a chain decides for all of it, and short doubled
/// parts stay.
class ChainedDoubles {
  public:
    ChainedDoubles(const WeldedMesh& mesh, std::vector<Intersection>& intersections)
        : mesh_(mesh), intersections_(intersections), known_(2 * intersections.size()) {}

    void drop(const std::vector<bool>& is_double, double diagonal) {
        std::vector<ChainEdge> edges;
        edges.reserve(intersections_.size());
        for (const Intersection& one : intersections_)
            edges.push_back({node(one.p), node(one.q), LA_KIND_INTERSECTION});
        std::vector<bool> is_dropped(intersections_.size(), false);
        for (const Chain& chain : chain_edges(nodes_, edges, sharpest_turn)) {
            double whole = 0, doubled = 0;
            for (const ChainStep step : chain.steps) {
                const double length = length_of(edges[step.edge]);
                whole += length;
                doubled += is_double[step.edge] ? length : 0;
            }
            if (2 * doubled >= whole) {
                for (const ChainStep step : chain.steps) is_dropped[step.edge] = true;
            } else {
                drop_long_runs(chain, edges, is_double, least_run * diagonal, is_dropped);
            }
        }
        std::size_t index = 0;
        std::erase_if(intersections_, [&](const Intersection&) { return is_dropped[index++]; });
    }

  private:
    static constexpr float sharpest_turn = 1.0471976F; ///< 60 degrees
    static constexpr double least_run = 0.01;          ///< share of the diagonal

    std::uint32_t node(const EdgePlace& place) {
        const auto fresh = static_cast<std::uint32_t>(nodes_.size());
        const auto share = std::bit_cast<std::uint64_t>(place.share + 0.0); // -0 becomes 0
        const std::uint32_t hash =
            hash_of(place.from, place.to, static_cast<std::uint32_t>(share ^ share >> 32U));
        const std::uint32_t node = known_.find_or_add(
            fresh, hash, [&](std::uint32_t known) { return places_[known] == place; });
        if (node == fresh) {
            const glm::dvec3 from{mesh_.vertices[place.from]}, to{mesh_.vertices[place.to]};
            nodes_.emplace_back(from + (to - from) * place.share);
            places_.push_back(place);
        }
        return node;
    }

    double length_of(const ChainEdge& edge) const {
        return glm::distance(glm::dvec3{nodes_[edge.p]}, glm::dvec3{nodes_[edge.q]});
    }

    void drop_long_runs(const Chain& chain, const std::vector<ChainEdge>& edges,
                        const std::vector<bool>& is_double, double least,
                        std::vector<bool>& is_dropped) const {
        for (std::size_t first = 0; first < chain.steps.size();) {
            std::size_t end = first;
            double length = 0;
            while (end < chain.steps.size() && is_double[chain.steps[end].edge])
                length += length_of(edges[chain.steps[end++].edge]);
            for (std::size_t i = first; i < end && length >= least; ++i)
                is_dropped[chain.steps[i].edge] = true;
            first = std::max(end, first + 1);
        }
    }

    const WeldedMesh& mesh_;
    std::vector<Intersection>& intersections_;
    std::vector<glm::vec3> nodes_;
    std::vector<EdgePlace> places_; ///< of nodes
    FirstSeen known_;
};

} // namespace

std::vector<Intersection> find_intersections(const WeldedMesh& mesh,
                                             const std::vector<glm::dvec3>& normals,
                                             const TriangleTree& tree, double diagonal) {
    const auto make = [&] { return Crossing{mesh, normals, diagonal}; };
    Crossing all = make();
    for (const Crossing& part : tree.visit_pairs_at<Crossing>(coplanar, make)) all.append(part);
    std::vector<Intersection> result = all.take();
    NearPlaces{mesh, diagonal, 2 * result.size()}.join(result);
    return result;
}

void drop_doubled(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
                  std::span<const DrawnLine> lines, double diagonal,
                  std::vector<Intersection>& intersections) {
    if (intersections.empty()) return;
    const std::vector<bool> is_double = Doubles{mesh, normals, lines, diagonal}.find(intersections);
    ChainedDoubles{mesh, intersections}.drop(is_double, diagonal);
}

} // namespace lineatlas
