#include "lineatlas/explode.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/name_pattern.hpp"
#include "base/printable.hpp"
#include "lineatlas/error.hpp"
#include "part_paths.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t none = PartPaths::none;

void check(const Explosion& explosion) {
    constexpr double most = 100;
    if (!(explosion.factor >= 1 && explosion.factor <= most))
        throw UsageError("explode: the factor must be from 1 to 100, not " +
                         std::to_string(explosion.factor));
    for (const PartMove& move : explosion.moves)
        if (!std::isfinite(glm::length(move.by)))
            throw UsageError("explode: \"" + printable(move.part) +
                             "\" moves by a number that is not finite");
}

/// A part of the tree. Nodes stand after the nodes that contain them.
struct Node {
    std::string path;
    std::uint32_t parent = none;
    glm::dvec3 low{INFINITY}, high{-INFINITY}; ///< the box of the part with all that it contains
    glm::dvec3 moved{0};

    bool is_empty() const { return !(low.x <= high.x); }
    glm::dvec3 middle() const { return 0.5 * (low + high); }
    void add(glm::dvec3 from, glm::dvec3 to) {
        low = glm::min(low, from);
        high = glm::max(high, to);
    }
};

/// The part that owns each of some numbered things. If several parts have one thing, each gets a
/// copy.
class PartOwners {
  public:
    explicit PartOwners(std::size_t count) : parts_(count, none) {}

    /// Makes `thing` the part's own. copy(thing) appends a copy of it behind all others.
    template <class Copy>
    void own(std::uint32_t& thing, std::uint32_t part, const Copy& copy) {
        if (parts_[thing] == none) parts_[thing] = part;
        if (parts_[thing] == part) return;
        const auto fresh = static_cast<std::uint32_t>(parts_.size());
        const auto [copied, is_new] = copies_.try_emplace({thing, part}, fresh);
        if (is_new) {
            copy(thing);
            parts_.push_back(part);
        }
        thing = copied->second;
    }
    const std::vector<std::uint32_t>& parts() const { return parts_; }

  private:
    std::vector<std::uint32_t> parts_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies_; ///< by thing and part
};

/// Moves parts of a mesh.
class Exploder {
  public:
    Exploder(LoadedMesh& model, const Explosion& explosion)
        : mesh_(model.mesh), explosion_(explosion), paths_(part_paths(model)) {
        plant(model.parts);
    }

    void explode() {
        check_names();
        own_positions();
        find_boxes();
        find_moves();
        move_surfaces();
        move_curves();
        for (std::size_t i = 0; i < mesh_.positions.size(); ++i)
            if (part_of_position_[i] != none)
                mesh_.positions[i] =
                    glm::vec3{glm::dvec3{mesh_.positions[i]} + moved(part_of_position_[i])};
        if (explosion_.trails) add_trails();
    }

  private:
    /// Makes the nodes. The root is the model. Parts of the tree follow in their order, or groups
    /// by their names.
    void plant(const std::vector<ModelPart>& parts) {
        nodes_.push_back({});
        node_of_part_.assign(paths_.paths.size(), 0);
        if (parts.empty()) {
            for (std::size_t i = 0; i < paths_.paths.size(); ++i) {
                node_of_part_[i] = static_cast<std::uint32_t>(nodes_.size());
                nodes_.push_back({.path = paths_.paths[i].whole(), .parent = 0});
            }
            return;
        }
        for (const ModelPart& part : parts) {
            const bool is_top = part.parent == ModelPart::none;
            const std::uint32_t parent = is_top ? 0 : part.parent + 1;
            if (part.object < node_of_part_.size())
                node_of_part_[part.object] = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back({.path = is_top ? part.name : nodes_[parent].path + '/' + part.name,
                              .parent = parent});
        }
    }

    /// Whether the pattern names the part itself, and not a part that contains it.
    bool names(const PartMove& move, const Node& node) const {
        if (!names_part(move.part, node.path)) return false;
        return node.parent == 0 || !names_part(move.part, nodes_[node.parent].path);
    }

    void check_names() const {
        for (const PartMove& move : explosion_.moves) {
            const auto is_named = [&](const Node& node) {
                return node.parent != none && names(move, node);
            };
            if (std::ranges::none_of(nodes_, is_named))
                throw UsageError("explode: no part is called \"" + printable(move.part) + "\"");
        }
    }

    /// Gives each part its own copy of positions that belong to several parts.
    void own_positions() {
        PartOwners owners{mesh_.positions.size()};
        const auto copy = [&](std::uint32_t position) {
            const glm::vec3 place = mesh_.positions[position];
            mesh_.positions.push_back(place);
        };
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k)
                owners.own(mesh_.triangles[i][k], paths_.of_triangle[i], copy);
        for (std::size_t i = 0; i < mesh_.polylines.size(); ++i)
            if (paths_.of_polyline[i] != none)
                for (std::uint32_t& position : mesh_.polylines[i])
                    owners.own(position, paths_.of_polyline[i], copy);
        part_of_position_ = owners.parts();
    }

    void find_boxes() {
        std::vector<bool> is_used(mesh_.positions.size(), false);
        for (const glm::uvec3& t : mesh_.triangles)
            is_used[t.x] = is_used[t.y] = is_used[t.z] = true;
        for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
            if (!is_used[i]) continue;
            const glm::dvec3 place{mesh_.positions[i]};
            nodes_[node_of_part_[part_of_position_[i]]].add(place, place);
        }
        for (std::size_t i = nodes_.size(); i-- > 1;)
            if (!nodes_[i].is_empty()) nodes_[nodes_[i].parent].add(nodes_[i].low, nodes_[i].high);
    }

    /// How far a part moves beside the part that contains it.
    glm::dvec3 own_move(const Node& node) const {
        const auto& moves = explosion_.moves;
        const auto by_hand = std::find_if(moves.rbegin(), moves.rend(),
                                          [&](const PartMove& move) { return names(move, node); });
        if (by_hand != moves.rend()) return by_hand->by;
        return (explosion_.factor - 1) * (node.middle() - nodes_[node.parent].middle());
    }

    void find_moves() {
        for (std::size_t i = 1; i < nodes_.size(); ++i)
            if (!nodes_[i].is_empty())
                nodes_[i].moved = nodes_[nodes_[i].parent].moved + own_move(nodes_[i]);
    }

    glm::dvec3 moved(std::uint32_t part) const { return nodes_[node_of_part_[part]].moved; }

    void move_surfaces() {
        KnownSurfaces& known = mesh_.surfaces;
        PartOwners owners{known.surfaces.size()};
        for (std::size_t i = 0; i < known.of_triangle.size(); ++i) {
            if (known.of_triangle[i] == KnownSurfaces::none) continue;
            owners.own(known.of_triangle[i], paths_.of_triangle[i], [&](std::uint32_t surface) {
                const PlacedSurface placed = known.surfaces[surface];
                known.surfaces.push_back(placed);
            });
        }
        for (std::size_t i = 0; i < known.surfaces.size(); ++i)
            if (owners.parts()[i] != none)
                known.surfaces[i].model_from_shape[3] += moved(owners.parts()[i]);
    }

    void move_curves() {
        std::vector<bool> is_done(mesh_.edge_curves.size(), false);
        for (const KnownEdge& edge : mesh_.known_edges) {
            if (edge.edge >= is_done.size() || is_done[edge.edge]) continue;
            is_done[edge.edge] = true;
            const std::uint32_t part = part_of_position_[edge.from];
            if (mesh_.edge_curves[edge.edge] && part != none)
                mesh_.edge_curves[edge.edge]->center += moved(part);
        }
    }

    void add_trails() {
        const double least = 1e-6 * glm::distance(nodes_[0].low, nodes_[0].high);
        for (std::size_t i = 1; i < nodes_.size(); ++i) {
            const Node& node = nodes_[i];
            const glm::dvec3 from = nodes_[node.parent].moved;
            if (node.is_empty() || glm::distance(from, node.moved) <= least) continue;
            const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
            mesh_.positions.emplace_back(node.middle() + from);
            mesh_.positions.emplace_back(node.middle() + node.moved);
            add_trail({first, first + 1});
        }
    }

    void add_trail(std::vector<std::uint32_t> line) {
        mesh_.polyline_kind.resize(mesh_.polylines.size(), PolylineKind::file);
        mesh_.polylines.push_back(std::move(line));
        mesh_.polyline_kind.push_back(PolylineKind::trail);
        // These lines belong to no part and move with none.
        if (!mesh_.polyline_object.empty())
            mesh_.polyline_object.push_back(static_cast<std::uint32_t>(paths_.paths.size()));
    }

    Mesh& mesh_;
    const Explosion& explosion_;
    PartPaths paths_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> node_of_part_;
    std::vector<std::uint32_t> part_of_position_;
};

} // namespace

void explode(LoadedMesh& model, const Explosion& explosion) {
    check(explosion);
    Exploder{model, explosion}.explode();
}

} // namespace lineatlas
