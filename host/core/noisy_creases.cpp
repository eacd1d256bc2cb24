#include "noisy_creases.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <glm/geometric.hpp>

#include "chain.hpp"
#include "diagonal.hpp"
#include "parts.hpp"
#include "vertex_sets.hpp"

namespace lineatlas {
namespace {

constexpr double degree = std::numbers::pi / 180;

// The gate.
constexpr double flat_share = 0.5; ///< where more of the faces are flat, a surface was designed;
constexpr double gridded_share = 0.75;      ///< or so many, in a part of which fewer than this are
constexpr double least_designed = 0.65;     ///< and which is rough: grids cut surfaces into quads.
constexpr double least_rough = 8 * degree;  ///< noise about an edge, of such grids
constexpr std::size_t least_gridded = 2000; ///< triangles of a part: grids are fine,
constexpr std::size_t least_symmetric = 5000;      ///< those of shapes with symmetries, too
constexpr std::size_t most_coarse_triangles = 200; ///< of a part; nobody scans so coarsely,
constexpr double least_coarse = 0.05;              ///< of the model's diagonal: but for crumbs

// Hysteresis: how far a crease stands out from the bends around it.
constexpr double weak_ratio = 2.4, most_weak = 60 * degree;
constexpr double strong_ratio = 3.1, most_strong = 80 * degree;
constexpr float sharpest_turn = 60 * static_cast<float>(degree); ///< of a chain

// The score of a chain.
constexpr double score_per_noise = 1.3 / degree; ///< mean edges of length, above quiet_noise
constexpr double quiet_noise = 5 * degree;
constexpr double loop_discount = 0.5;
constexpr std::size_t straightness_window = 4; ///< edges

// The least network.
constexpr double least_network = 0.012; ///< of the model's diagonal
constexpr int least_loop_edges = 9;
constexpr double most_fading = 45 * degree; ///< of a fold that ends in smooth surface everywhere
constexpr int most_stub_edges = 2;          ///< of one that is no line in any surface

/// Rings of edges around a vertex that count as its surroundings.
constexpr int rings = 2;

/// Sums per vertex, spread to the vertices around it.
class Surroundings {
  public:
    explicit Surroundings(std::size_t vertices) : sums_(vertices), weights_(vertices) {}

    void add(std::uint32_t vertex, double value, double weight) {
        sums_[vertex] += value * weight;
        weights_[vertex] += weight;
    }
    void spread(const std::vector<MeshEdge>& edges) {
        for (int ring = 0; ring < rings; ++ring) {
            spread(edges, sums_);
            spread(edges, weights_);
        }
    }
    /// The mean about an edge; 0 where there is nothing.
    double about(const MeshEdge& edge) const {
        const double weight = weights_[edge.p] + weights_[edge.q];
        return weight > 0 ? (sums_[edge.p] + sums_[edge.q]) / weight : 0;
    }

  private:
    static void spread(const std::vector<MeshEdge>& edges, std::vector<double>& values) {
        std::vector<double> wider = values;
        for (const MeshEdge& edge : edges) {
            wider[edge.p] += values[edge.q];
            wider[edge.q] += values[edge.p];
        }
        values = std::move(wider);
    }

    std::vector<double> sums_, weights_;
};

/// Vertices that lines connect, with what the lines amount to.
class Networks {
  public:
    explicit Networks(std::size_t vertices) : sets_(vertices), of_(vertices) {}

    /// An edge that is drawn whatever the view; the bend of a crease, else pi.
    void add(const MeshEdge& edge, double length, double bend) {
        const std::uint32_t a = sets_.find(edge.p), b = sets_.find(edge.q);
        const std::uint32_t joined = sets_.unite(a, b);
        const Network& other = of_[joined == a ? b : a];
        Network& network = of_[joined];
        if (a == b) {
            network.cyclic = true;
        } else {
            network.cyclic = network.cyclic || other.cyclic;
            network.length += other.length;
            network.edges += other.edges;
            network.sharpest = std::max(network.sharpest, other.sharpest);
        }
        network.sharpest = std::max(network.sharpest, bend);
        network.length += length;
        ++network.edges;
    }
    bool is_crumb(const MeshEdge& edge, double diagonal) {
        const Network& network = of_[sets_.find(edge.p)];
        return network.length < least_network * diagonal &&
               (!network.cyclic || network.edges < least_loop_edges);
    }

    /// Folds that end in smooth surface and nowhere else.
    bool fades(const MeshEdge& edge) {
        const Network& network = of_[sets_.find(edge.p)];
        return !network.cyclic && network.sharpest < most_fading;
    }
    bool is_stub(const MeshEdge& edge) {
        return of_[sets_.find(edge.p)].edges <= most_stub_edges && fades(edge);
    }

  private:
    struct Network {
        double length = 0;
        double sharpest = 0;
        int edges = 0;
        bool cyclic = false;
    };

    VertexSets sets_;
    std::vector<Network> of_;
};

/// Which parts are of a shape that repeats itself: of most of their edges there is another one, as
/// long and bent as much. What turns about an axis or has two equal halves was designed; no scan
/// is like that.
class RepeatingParts {
  public:
    RepeatingParts(const MeshParts& parts, const std::vector<std::uint32_t>& wanted)
        : parts_(parts), is_wanted_(parts.count), repeats_(parts.count) {
        for (const std::uint32_t part : wanted) is_wanted_[part] = true;
    }

    void add(const MeshEdge& edge, double bend, double length) {
        const std::uint32_t part = parts_.of_vertex[edge.p];
        if (!is_wanted_[part]) return;
        shapes_.push_back(
            {part, static_cast<std::uint32_t>(std::lround(bend / bend_step)), length});
    }

    void compare() {
        std::ranges::sort(shapes_);
        for (std::size_t first = 0; first < shapes_.size();) {
            std::size_t end = first;
            while (end < shapes_.size() && shapes_[end].part == shapes_[first].part) ++end;
            const std::span of_part = std::span{shapes_}.subspan(first, end - first);
            repeats_[shapes_[first].part] =
                2 * twins_in(of_part) > static_cast<std::ptrdiff_t>(of_part.size());
            first = end;
        }
    }

    bool contain(const MeshEdge& edge) const { return repeats_[parts_.of_vertex[edge.p]]; }

  private:
    struct EdgeShape {
        std::uint32_t part, bend;
        double length;
        auto operator<=>(const EdgeShape&) const = default;
    };

    static constexpr double bend_step = 0.01 * degree;

    static std::ptrdiff_t twins_in(std::span<const EdgeShape> edges) {
        // Of very many edges some are alike by chance.
        const double alike = std::min(5e-4, 75 / static_cast<double>(edges.size()));
        const auto are_twins = [&](const EdgeShape& a, const EdgeShape& b) {
            return a.bend == b.bend && b.length - a.length <= alike * b.length;
        };
        std::ptrdiff_t twins = 0;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const bool has_twin = (i > 0 && are_twins(edges[i - 1], edges[i])) ||
                                  (i + 1 < edges.size() && are_twins(edges[i], edges[i + 1]));
            twins += has_twin ? 1 : 0;
        }
        return twins;
    }

    const MeshParts& parts_;
    std::vector<bool> is_wanted_, repeats_;
    std::vector<EdgeShape> shapes_;
};

class CreaseFilter {
  public:
    CreaseFilter(const WeldedMesh& mesh, const MeshParts& parts, const std::vector<MeshEdge>& edges,
                 std::span<const double> bends, std::span<const std::optional<LineKind>> kinds)
        : mesh_(mesh), parts_(parts), edges_(edges), bends_(bends), kinds_(kinds),
          noisy_(edges.size(), false) {}

    std::vector<bool> run() {
        find_doubtful();
        if (!doubtful_.empty()) {
            measure_noise();
            measure_edge_lengths();
            keep_chains();
        }
        drop_networks();
        return std::move(noisy_);
    }

  private:
    bool is_crease(std::size_t i) const { return kinds_[i] == LineKind::crease; }

    double length(const MeshEdge& edge) const {
        return glm::distance(glm::dvec3{mesh_.vertices[edge.p]},
                             glm::dvec3{mesh_.vertices[edge.q]});
    }

    /// Creases of surfaces that nobody designed. A designed one is cut into triangles along lines
    /// that need not be there, and so flat across many of them; or it repeats itself; or it is so
    /// coarse that each of its edges was drawn.
    void find_doubtful() {
        const std::vector<bool> is_flat = flat_faces(mesh_.triangles.size(), edges_, bends_);
        Surroundings flatness{mesh_.vertices.size()};
        for (std::size_t face = 0; face < is_flat.size(); ++face) {
            for (int k = 0; k < 3; ++k)
                flatness.add(mesh_.triangles[face][k], is_flat[face] ? 1 : 0, 1);
        }
        flatness.spread(edges_);
        is_gridded_.assign(edges_.size(), false);
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            const double share = flatness.about(edges_[i]);
            if (!is_crease(i) || share > gridded_share) continue;
            is_gridded_[i] = share > flat_share;
            doubtful_.push_back(i);
        }
        if (doubtful_.empty()) return;
        count_triangles();
        const std::vector<bool> gridded = gridded_parts(is_flat);
        std::erase_if(doubtful_, [&](std::uint32_t i) {
            return is_gridded_[i] && !gridded[parts_.of_vertex[edges_[i].p]];
        });
        const std::vector<std::uint32_t> curved = doubtful_;
        trust_coarse_parts();
        trust_repeating_parts();
        std::ranges::set_difference(curved, doubtful_, std::back_inserter(trusted_));
        std::erase_if(trusted_, [&](std::uint32_t i) { return is_gridded_[i]; });
    }

    void count_triangles() {
        triangles_of_.assign(parts_.count, 0);
        for (const glm::uvec3& t : mesh_.triangles) ++triangles_of_[parts_.of_vertex[t.x]];
    }

    std::vector<bool> gridded_parts(const std::vector<bool>& is_flat) {
        std::vector<std::size_t> flat(parts_.count, 0);
        for (std::size_t face = 0; face < is_flat.size(); ++face)
            flat[parts_.of_vertex[mesh_.triangles[face].x]] += is_flat[face] ? 1 : 0;
        std::vector<bool> gridded;
        for (std::size_t part = 0; part < parts_.count; ++part)
            gridded.push_back(triangles_of_[part] >= least_gridded &&
                              static_cast<double>(flat[part]) <
                                  least_designed * static_cast<double>(triangles_of_[part]));
        return gridded;
    }

    void trust_coarse_parts() {
        std::vector<std::vector<glm::vec3>> vertices(parts_.count);
        for (std::uint32_t i = 0; i < mesh_.vertices.size(); ++i) {
            const std::uint32_t part = parts_.of_vertex[i];
            if (triangles_of_[part] <= most_coarse_triangles)
                vertices[part].push_back(mesh_.vertices[i]);
        }
        const double least = least_coarse * diagonal_of(mesh_.vertices);
        std::vector<bool> is_coarse;
        for (const std::vector<glm::vec3>& part : vertices)
            is_coarse.push_back(!part.empty() && diagonal_of(part) >= least);
        std::erase_if(doubtful_,
                      [&](std::uint32_t i) { return is_coarse[parts_.of_vertex[edges_[i].p]]; });
    }

    void trust_repeating_parts() {
        std::vector<std::uint32_t> wanted;
        for (const std::uint32_t i : doubtful_) wanted.push_back(parts_.of_vertex[edges_[i].p]);
        RepeatingParts repeating{parts_, wanted};
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (edges_[i].face_count == 2 && bends_[i] >= flat_bend)
                repeating.add(edges_[i], bends_[i], length(edges_[i]));
        }
        repeating.compare();
        is_symmetric_.assign(edges_.size(), false);
        std::erase_if(doubtful_, [&](std::uint32_t i) {
            if (!repeating.contain(edges_[i])) return false;
            is_symmetric_[i] = triangles_of_[parts_.of_vertex[edges_[i].p]] >= least_symmetric;
            return !is_symmetric_[i];
        });
    }

    /// The noise about an edge: root of the mean square of bends that are no creases at any angle,
    /// by length.
    void measure_noise() {
        Surroundings squares{mesh_.vertices.size()};
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const MeshEdge& edge = edges_[i];
            if (edge.face_count != 2 || bends_[i] >= double{least_crease_angle}) continue;
            for (const std::uint32_t vertex : {edge.p, edge.q})
                squares.add(vertex, bends_[i] * bends_[i], length(edge));
        }
        squares.spread(edges_);
        const auto noise_about = [&](std::uint32_t i) {
            return std::sqrt(squares.about(edges_[i]));
        };
        std::erase_if(doubtful_, [&](std::uint32_t i) {
            const bool goes = (is_gridded_[i] || is_symmetric_[i]) && noise_about(i) < least_rough;
            if (goes && !is_gridded_[i]) trusted_.push_back(i);
            return goes;
        });
        std::ranges::transform(doubtful_, std::back_inserter(noise_), noise_about);
    }

    void measure_edge_lengths() {
        lengths_.assign(mesh_.vertices.size(), {});
        for (const MeshEdge& edge : edges_) {
            for (const std::uint32_t vertex : {edge.p, edge.q}) {
                lengths_[vertex].sum += length(edge);
                ++lengths_[vertex].count;
            }
        }
    }

    void keep_chains() {
        std::vector<std::uint32_t> weak; // into doubtful_
        std::vector<ChainEdge> to_chain;
        for (std::uint32_t k = 0; k < doubtful_.size(); ++k) {
            const std::uint32_t i = doubtful_[k];
            noisy_[i] = true;
            const double threshold =
                std::clamp(weak_ratio * noise_[k], double{least_crease_angle}, most_weak);
            if (bends_[i] <= threshold) continue;
            weak.push_back(k);
            to_chain.push_back({edges_[i].p, edges_[i].q, LA_KIND_CREASE});
        }
        for (Chain& chain : chain_edges(mesh_.vertices, to_chain, sharpest_turn)) {
            for (ChainStep& step : chain.steps) step.edge = weak[step.edge];
            if (!is_line(chain)) continue;
            for (const ChainStep step : chain.steps) noisy_[doubtful_[step.edge]] = false;
        }
    }

    bool is_strong(std::uint32_t k) const {
        return bends_[doubtful_[k]] > std::min(strong_ratio * noise_[k], most_strong);
    }

    /// Of a chain whose steps are of `doubtful_`.
    bool is_line(const Chain& chain) const {
        double weight = 0, noise = 0, whole = 0;
        EdgeLengths around;
        bool strong = false;
        for (const ChainStep step : chain.steps) {
            const MeshEdge& edge = edges_[doubtful_[step.edge]];
            const double length = this->length(edge);
            whole += length;
            weight += length * bends_[doubtful_[step.edge]] / double{least_crease_angle};
            noise += noise_[step.edge] * length;
            strong = strong || is_strong(step.edge);
            for (const std::uint32_t vertex : {edge.p, edge.q}) {
                around.sum += lengths_[vertex].sum;
                around.count += lengths_[vertex].count;
            }
        }
        if (!strong) return false;
        const double score = weight * std::pow(straightness(chain), 3);
        const double mean_edge = around.sum / around.count;
        const double least = score_per_noise * (noise / whole - quiet_noise) * mean_edge;
        return score >= (chain.closed ? loop_discount * least : least);
    }

    /// Chord over arc, of a few edges each.
    double straightness(const Chain& chain) const {
        std::vector<glm::dvec3> points;
        for (const ChainStep step : chain.steps) {
            const MeshEdge& edge = edges_[doubtful_[step.edge]];
            if (points.empty())
                points.emplace_back(mesh_.vertices[step.reversed ? edge.q : edge.p]);
            points.emplace_back(mesh_.vertices[step.reversed ? edge.p : edge.q]);
        }
        std::vector<double> arc{0};
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            arc.push_back(arc[i] + glm::distance(points[i], points[i + 1]));
        double chords = 0, arcs = 0;
        const std::size_t window = std::min(straightness_window, points.size() - 1);
        for (std::size_t i = 0; i + window < points.size(); ++i) {
            chords += glm::distance(points[i], points[i + window]);
            arcs += arc[i + window] - arc[i];
        }
        return arcs > 0 ? chords / arcs : 1;
    }

    /// What is left and too small, beside nothing else that is drawn whatever the view. And folds
    /// that fade at all their ends: the surface is smooth there, bent a little more than the least
    /// for a crease and less around. Of curved parts that are no scans, as surfaces of
    /// subdivision, all of them; of others an edge or two.
    void drop_networks() {
        Networks networks{mesh_.vertices.size()};
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const bool is_fixed =
                kinds_[i] ? *kinds_[i] != LineKind::silhouette : edges_[i].face_count != 2;
            if (!is_fixed || noisy_[i]) continue;
            networks.add(edges_[i], length(edges_[i]), is_crease(i) ? bends_[i] : std::numbers::pi);
        }
        const double diagonal = diagonal_of(mesh_.vertices);
        for (const std::uint32_t i : doubtful_)
            noisy_[i] = noisy_[i] || (!is_gridded_[i] && networks.is_crumb(edges_[i], diagonal));
        for (const std::uint32_t i : trusted_) noisy_[i] = networks.fades(edges_[i]);
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (is_crease(i)) noisy_[i] = noisy_[i] || networks.is_stub(edges_[i]);
    }

    struct EdgeLengths {
        double sum = 0;
        int count = 0;
    };

    const WeldedMesh& mesh_;
    const MeshParts& parts_;
    const std::vector<MeshEdge>& edges_;
    std::span<const double> bends_;
    std::span<const std::optional<LineKind>> kinds_;
    std::vector<bool> noisy_;
    std::vector<std::size_t> triangles_of_; ///< each part
    /// Edges that are doubtful only where it is rough: of parts with many flat faces, and of those
    /// that repeat themselves.
    std::vector<bool> is_gridded_, is_symmetric_;
    std::vector<std::uint32_t> doubtful_; ///< edges
    std::vector<std::uint32_t> trusted_;  ///< edges of parts that are curved, but no scans
    std::vector<double> noise_;           ///< of each doubtful one
    std::vector<EdgeLengths> lengths_;    ///< of the edges at each vertex
};

} // namespace

std::vector<bool> noisy_creases(const WeldedMesh& mesh, const MeshParts& parts,
                                const std::vector<MeshEdge>& edges, std::span<const double> bends,
                                std::span<const std::optional<LineKind>> kinds) {
    return CreaseFilter{mesh, parts, edges, bends, kinds}.run();
}

} // namespace lineatlas
