#include "noisy_creases.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "base/vertex_sets.hpp"
#include "core/chain.hpp"
#include "diagonal.hpp"
#include "parts.hpp"

namespace lineatlas {
namespace {

constexpr double degree = std::numbers::pi / 180;

// The gate.
constexpr double flat_share = 0.5;      ///< a larger share of flat faces means a designed surface
constexpr double gridded_share = 0.75;  ///< the same in gridded parts that are rough
constexpr double least_designed = 0.65; ///< a smaller share of flat faces makes a part gridded
constexpr double least_rough = 8 * degree;  ///< noise about an edge of a rough part
constexpr std::size_t least_gridded = 2000; ///< triangles of a gridded part, because grids are fine
constexpr std::size_t least_symmetric = 5000;      ///< triangles of a noisy part with symmetries
constexpr std::size_t most_coarse_triangles = 200; ///< of a part; nobody scans so coarsely
constexpr double least_coarse = 0.05; ///< of the model's diagonal; smaller parts are crumbs

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
constexpr int most_stub_edges = 2;          ///< of a network that is no line in any surface

/// Rings of edges around a vertex that count as its surroundings.
constexpr int rings = 2;

/// The edges at a vertex, in their order, with the vertices at their other ends.
class EdgesAtVertices {
  public:
    EdgesAtVertices(std::size_t vertices, const std::vector<MeshEdge>& edges)
        : edges_(edges), first_(first_edges(vertices, edges)),
          to_smaller_(vertices, edges.size(), [&](std::size_t i, const auto& add) {
              const auto [smaller, larger] = std::minmax(edges[i].p, edges[i].q);
              add(larger, End{static_cast<std::uint32_t>(i), smaller});
          }) {
        for_each_index(vertices,
                       [&](std::size_t v) { std::ranges::sort(to_smaller_[v], {}, &End::edge); });
    }

    /// Calls each(edge, other end).
    template <class Each>
    void visit(std::size_t vertex, const Each& each) const {
        for (const auto [edge, other] : to_smaller_[vertex]) each(edge, other);
        // Edges are ordered by their smaller vertex.
        for (std::uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i)
            each(i, std::max(edges_[i].p, edges_[i].q));
    }

  private:
    struct End {
        std::uint32_t edge, vertex;
    };

    const std::vector<MeshEdge>& edges_;
    std::vector<std::uint32_t> first_; ///< edge to a larger vertex
    Groups<End> to_smaller_;
};

/// Sums per vertex, spread to the vertices around it.
class Surroundings {
  public:
    explicit Surroundings(std::size_t vertices) : sums_(vertices) {}

    /// `value`: times its weight.
    void add(std::uint32_t vertex, double value, double weight) {
        sums_[vertex] += {value, weight};
    }
    void spread(const EdgesAtVertices& around) {
        for (int ring = 0; ring < rings; ++ring) {
            std::vector<Sum> wider = sums_;
            for_each_index(sums_.size(), [&](std::size_t v) {
                around.visit(v,
                             [&](std::uint32_t, std::uint32_t other) { wider[v] += sums_[other]; });
            });
            sums_ = std::move(wider);
        }
    }
    /// The mean about an edge; 0 if nothing was added there.
    double about(const MeshEdge& edge) const {
        const double weight = sums_[edge.p].weight + sums_[edge.q].weight;
        return weight > 0 ? (sums_[edge.p].value + sums_[edge.q].value) / weight : 0;
    }

  private:
    struct Sum {
        double value = 0, weight = 0;
        void operator+=(const Sum& other) {
            value += other.value;
            weight += other.weight;
        }
    };

    std::vector<Sum> sums_;
};

/// Networks of vertices that are connected by lines, with properties of the lines.
class Networks {
  public:
    explicit Networks(std::size_t vertices) : sets_(vertices), of_(vertices) {}

    /// Adds an edge that is drawn in every view. bend: that of a crease, else pi.
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
    /// Call after all edges are added and before any question.
    void close() {
        name_.resize(of_.size());
        for (std::uint32_t v = 0; v < of_.size(); ++v) name_[v] = sets_.find(v);
    }

    bool is_crumb(const MeshEdge& edge, double diagonal) const {
        const Network& network = of_[name_[edge.p]];
        return network.length < least_network * diagonal &&
               (!network.cyclic || network.edges < least_loop_edges);
    }

    /// Whether the network of an edge is folds that end only in smooth surface.
    bool fades(const MeshEdge& edge) const {
        const Network& network = of_[name_[edge.p]];
        return !network.cyclic && network.sharpest < most_fading;
    }
    bool is_stub(const MeshEdge& edge) const {
        return of_[name_[edge.p]].edges <= most_stub_edges && fades(edge);
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
    std::vector<std::uint32_t> name_; ///< per vertex, of its network
};

/// Finds parts whose shape repeats itself: most of their edges have a twin of the same length and
/// bend. Shapes that turn about an axis or have two equal halves were designed, because no scan is
/// like that.
class RepeatingParts {
  public:
    RepeatingParts(const MeshParts& parts, const std::vector<std::uint32_t>& wanted)
        : parts_(parts), is_wanted_(parts.count), repeats_(parts.count) {
        for (const std::uint32_t part : wanted) is_wanted_[part] = true;
    }

    /// Adds edges. length(edge) is the length of an edge.
    template <class Length>
    void add(const std::vector<MeshEdge>& edges, std::span<const double> bends,
             const Length& length) {
        const auto find = [&](std::size_t first, std::size_t end) {
            std::vector<EdgeShape> shapes;
            for (std::size_t i = first; i < end; ++i) {
                const std::uint32_t part = parts_.of_vertex[edges[i].p];
                if (edges[i].face_count != 2 || bends[i] < flat_bend || !is_wanted_[part]) continue;
                const auto bend = static_cast<std::uint32_t>(std::lround(bends[i] / bend_step));
                shapes.push_back({part, bend, length(edges[i])});
            }
            return shapes;
        };
        shapes_ =
            joined(made_of_pieces<std::vector<EdgeShape>>(edges.size(), 8 * usual_piece, find));
    }

    void compare() {
        sort_in_pieces(shapes_);
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

        bool operator<(const EdgeShape& other) const {
            const std::uint64_t own = of(part, bend), others = of(other.part, other.bend);
            return own != others ? own < others : length < other.length;
        }

      private:
        static std::uint64_t of(std::uint32_t part, std::uint32_t bend) {
            return std::uint64_t{part} << 32U | bend;
        }
    };

    static constexpr double bend_step = 0.01 * degree;

    static std::ptrdiff_t twins_in(std::span<const EdgeShape> edges) {
        // Among very many edges some are alike by chance.
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
        : mesh_(mesh), parts_(parts), edges_(edges), around_(mesh.vertices.size(), edges),
          bends_(bends), kinds_(kinds), noisy_(edges.size(), false) {}

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

    /// Finds creases of undesigned surfaces. A designed surface is flat across many edges, because
    /// triangles cut its faces; or it repeats itself; or it is so coarse that each of its edges was
    /// drawn.
    void find_doubtful() {
        const std::vector<bool> is_flat = flat_faces(mesh_.triangles.size(), edges_, bends_);
        const Surroundings flatness = flatness_of(is_flat);
        is_gridded_.assign(edges_.size(), false);
        const auto find = [&](std::size_t first, std::size_t end) {
            std::vector<std::uint32_t> doubtful;
            for (auto i = static_cast<std::uint32_t>(first); i < end; ++i) {
                if (!is_crease(i)) continue;
                const double share = flatness.about(edges_[i]);
                if (share > gridded_share) continue;
                is_gridded_[i] = share > flat_share;
                doubtful.push_back(i);
            }
            return doubtful;
        };
        doubtful_ =
            joined(made_of_pieces<std::vector<std::uint32_t>>(edges_.size(), usual_piece, find));
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

    /// The share of flat triangles about an edge.
    Surroundings flatness_of(const std::vector<bool>& is_flat) const {
        constexpr std::uint64_t one = std::uint64_t{1} << 32U; // flat ones below
        std::vector<std::atomic<std::uint64_t>> counts(mesh_.vertices.size());
        for_each_index(is_flat.size(), [&](std::size_t face) {
            for (int k = 0; k < 3; ++k)
                counts[mesh_.triangles[face][k]].fetch_add(one | (is_flat[face] ? 1U : 0U),
                                                           std::memory_order_relaxed);
        });
        Surroundings flatness{mesh_.vertices.size()};
        for_each_index(counts.size(), [&](std::size_t v) {
            const std::uint64_t count = counts[v].load(std::memory_order_relaxed);
            flatness.add(static_cast<std::uint32_t>(v), static_cast<double>(count % one),
                         static_cast<double>(count / one));
        });
        flatness.spread(around_);
        return flatness;
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
        repeating.add(edges_, bends_, [&](const MeshEdge& edge) { return length(edge); });
        repeating.compare();
        is_symmetric_.assign(edges_.size(), false);
        std::erase_if(doubtful_, [&](std::uint32_t i) {
            if (!repeating.contain(edges_[i])) return false;
            is_symmetric_[i] = triangles_of_[parts_.of_vertex[edges_[i].p]] >= least_symmetric;
            return !is_symmetric_[i];
        });
    }

    /// Measures the noise about an edge: the root mean square, weighted by length, of bends that
    /// are no creases at any angle.
    void measure_noise() {
        Surroundings squares{mesh_.vertices.size()};
        for_each_index(mesh_.vertices.size(), [&](std::size_t v) {
            around_.visit(v, [&](std::uint32_t i, std::uint32_t) {
                if (edges_[i].face_count != 2 || bends_[i] >= double{least_crease_angle}) return;
                const double weight = length(edges_[i]);
                squares.add(static_cast<std::uint32_t>(v), bends_[i] * bends_[i] * weight, weight);
            });
        });
        squares.spread(around_);
        const auto noise_about = [&](std::uint32_t i) {
            return std::sqrt(squares.about(edges_[i]));
        };
        std::erase_if(doubtful_, [&](std::uint32_t i) {
            const bool goes = (is_gridded_[i] || is_symmetric_[i]) && noise_about(i) < least_rough;
            if (goes && !is_gridded_[i]) trusted_.push_back(i);
            return goes;
        });
        noise_.resize(doubtful_.size());
        for_each_index(noise_.size(),
                       [&](std::size_t k) { noise_[k] = noise_about(doubtful_[k]); });
    }

    void measure_edge_lengths() {
        lengths_.assign(mesh_.vertices.size(), {});
        for_each_index(lengths_.size(), [&](std::size_t v) {
            around_.visit(v, [&](std::uint32_t i, std::uint32_t) {
                lengths_[v].sum += length(edges_[i]);
                ++lengths_[v].count;
            });
        });
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
        const Chains chains = chain_edges(mesh_.vertices, to_chain, sharpest_turn);
        std::vector<char> are_lines(chains.size());
        for_each_index(
            chains.size(), [&](std::size_t i) { are_lines[i] = is_line(chains[i], weak); },
            usual_piece / 8);
        for (std::size_t i = 0; i < chains.size(); ++i) {
            if (!are_lines[i]) continue;
            for (const ChainStep step : chains[i].steps) noisy_[doubtful_[weak[step.edge]]] = false;
        }
    }

    bool is_strong(std::uint32_t k) const {
        return bends_[doubtful_[k]] > std::min(strong_ratio * noise_[k], most_strong);
    }

    /// Whether a chain is a line. Its steps are numbers in `weak`, which holds numbers in
    /// `doubtful_`.
    bool is_line(const Chain& chain, std::span<const std::uint32_t> weak) const {
        double weight = 0, noise = 0, whole = 0;
        EdgeLengths around;
        bool strong = false;
        for (const ChainStep step : chain.steps) {
            const std::uint32_t doubtful = weak[step.edge];
            const MeshEdge& edge = edges_[doubtful_[doubtful]];
            const double length = this->length(edge);
            whole += length;
            weight += length * bends_[doubtful_[doubtful]] / double{least_crease_angle};
            noise += noise_[doubtful] * length;
            strong = strong || is_strong(doubtful);
            for (const std::uint32_t vertex : {edge.p, edge.q}) {
                around.sum += lengths_[vertex].sum;
                around.count += lengths_[vertex].count;
            }
        }
        if (!strong) return false;
        const double score = weight * std::pow(straightness(chain, weak), 3);
        const double mean_edge = around.sum / around.count;
        const double least = score_per_noise * (noise / whole - quiet_noise) * mean_edge;
        return score >= (chain.closed ? loop_discount * least : least);
    }

    /// Chord over arc, for a few edges at a time.
    double straightness(const Chain& chain, std::span<const std::uint32_t> weak) const {
        std::vector<glm::dvec3> points;
        for (const ChainStep step : chain.steps) {
            const MeshEdge& edge = edges_[doubtful_[weak[step.edge]]];
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

    /// Drops networks that are too small and not connected to other lines. Also drops folds that
    /// fade at all of their ends, where the surface is smooth and bends a little more than the
    /// crease angle: in curved parts that are no scans, such as subdivision surfaces, all such
    /// folds; in other parts those of an edge or two.
    void drop_networks() {
        Networks networks{mesh_.vertices.size()};
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const bool is_fixed =
                kinds_[i] ? *kinds_[i] != LineKind::silhouette : edges_[i].face_count != 2;
            if (!is_fixed || noisy_[i]) continue;
            networks.add(edges_[i], length(edges_[i]), is_crease(i) ? bends_[i] : std::numbers::pi);
        }
        networks.close();
        const double diagonal = diagonal_of(mesh_.vertices);
        for (const std::uint32_t i : doubtful_)
            noisy_[i] = noisy_[i] || (!is_gridded_[i] && networks.is_crumb(edges_[i], diagonal));
        for (const std::uint32_t i : trusted_) noisy_[i] = networks.fades(edges_[i]);
        // Pieces write to their own words of bits.
        for_each_index(edges_.size(), [&](std::size_t i) {
            if (is_crease(i)) noisy_[i] = noisy_[i] || networks.is_stub(edges_[i]);
        });
    }

    struct EdgeLengths {
        double sum = 0;
        int count = 0;
    };

    const WeldedMesh& mesh_;
    const MeshParts& parts_;
    const std::vector<MeshEdge>& edges_;
    EdgesAtVertices around_;
    std::span<const double> bends_;
    std::span<const std::optional<LineKind>> kinds_;
    std::vector<bool> noisy_;
    std::vector<std::size_t> triangles_of_; ///< each part
    /// Parts whose edges are doubtful only where the surface is rough: parts with many flat faces,
    /// and parts that repeat themselves.
    std::vector<bool> is_gridded_, is_symmetric_;
    std::vector<std::uint32_t> doubtful_; ///< edges
    std::vector<std::uint32_t> trusted_;  ///< edges of parts that are curved, but no scans
    std::vector<double> noise_;           ///< about each doubtful edge
    std::vector<EdgeLengths> lengths_;    ///< of the edges at each vertex
};

} // namespace

std::vector<bool> noisy_creases(const WeldedMesh& mesh, const MeshParts& parts,
                                const std::vector<MeshEdge>& edges, std::span<const double> bends,
                                std::span<const std::optional<LineKind>> kinds) {
    if (std::ranges::find(kinds, LineKind::crease) == kinds.end())
        return std::vector<bool>(edges.size(), false);
    return CreaseFilter{mesh, parts, edges, bends, kinds}.run();
}

} // namespace lineatlas
