#include "t_junctions.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "cracks.hpp"
#include "diagonal.hpp"

namespace lineatlas {
namespace {

/// Boundaries at a corner that are compared with each other. A surface has no more.
constexpr std::size_t most_at_vertex = 16;

/// A corner within a boundary, by its way from the boundary's p.
struct Corner {
    std::uint32_t edge;
    double way;
    std::uint32_t vertex;

    auto place() const { return std::tuple{edge, way, vertex}; }
};

class Finder {
  public:
    Finder(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges)
        : mesh_(mesh), edges_(edges), widest_(widest_crack_of(mesh)),
          boundaries_(mesh.vertices.size(), edges.size(), [&](std::size_t i, const auto& add) {
              const MeshEdge& edge = edges_[i];
              if (edge.face_count != 1 ||
                  !(distance(edge.p, edge.q) > least_lengths_of_crack * widest_))
                  return;
              add(edge.p, static_cast<std::uint32_t>(i));
              add(edge.q, static_cast<std::uint32_t>(i));
          }) {
        for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
            std::ranges::sort(boundaries_[vertex]);
    }

    /// Finds the corners, sorted by edge and along each edge.
    std::vector<Corner> find() {
        for (std::uint32_t vertex = 0; vertex < mesh_.vertices.size(); ++vertex) {
            const std::span<const std::uint32_t> here = boundaries_[vertex];
            if (here.size() > most_at_vertex) continue;
            for (std::size_t i = 0; i < here.size(); ++i)
                for (std::size_t k = i + 1; k < here.size(); ++k) follow(vertex, here[i], here[k]);
        }
        std::ranges::sort(found_, {}, &Corner::place);
        const auto same = [](const Corner& a, const Corner& b) {
            return a.edge == b.edge && a.vertex == b.vertex;
        };
        found_.erase(std::ranges::unique(found_, same).begin(), found_.end());
        return std::move(found_);
    }

  private:
    glm::dvec3 at(std::uint32_t vertex) const { return glm::dvec3{mesh_.vertices[vertex]}; }
    double distance(std::uint32_t a, std::uint32_t b) const { return glm::distance(at(a), at(b)); }
    std::uint32_t other_end(std::uint32_t edge, std::uint32_t vertex) const {
        return edges_[edge].p == vertex ? edges_[edge].q : edges_[edge].p;
    }

    /// Whether a vertex lies beside the way from one to another, and not beyond its ends.
    bool is_on(std::uint32_t vertex, std::uint32_t from, std::uint32_t to) const {
        const glm::dvec3 way = at(to) - at(from), out = at(vertex) - at(from);
        const double along = glm::dot(out, way) / glm::dot(way, way);
        return along > 0 && along < 1 && glm::length(out - along * way) <= widest_;
    }

    /// Follows two boundaries from a corner on as long as they run along each other: normally to
    /// the next corner that they have in common.
    void follow(std::uint32_t start, std::uint32_t a, std::uint32_t b) {
        std::uint32_t from_a = start, from_b = start;
        while (edges_[a].face_a != edges_[b].face_a) {
            const std::uint32_t end_a = other_end(a, from_a), end_b = other_end(b, from_b);
            if (end_a == end_b) return;
            if (is_on(end_a, from_b, end_b)) {
                add(b, end_a);
                if (!step(a, from_a, end_a)) return;
            } else if (is_on(end_b, from_a, end_a)) {
                add(a, end_b);
                if (!step(b, from_b, end_b)) return;
            } else {
                return;
            }
        }
    }

    void add(std::uint32_t edge, std::uint32_t vertex) {
        found_.push_back({edge, distance(edges_[edge].p, vertex), vertex});
    }

    /// Goes on from the end of an edge to the next boundary. Returns false if there is none.
    bool step(std::uint32_t& edge, std::uint32_t& from, std::uint32_t end) const {
        const std::span<const std::uint32_t> here = boundaries_[end];
        if (here.size() > most_at_vertex) return false;
        for (const std::uint32_t next : here) {
            if (next == edge || !is_on(end, from, other_end(next, end))) continue;
            edge = next;
            from = end;
            return true;
        }
        return false;
    }

    const WeldedMesh& mesh_;
    const std::vector<MeshEdge>& edges_;
    double widest_;
    Groups<std::uint32_t> boundaries_; ///< by vertex, ascending
    std::vector<Corner> found_;
};

/// Divides triangles with corners within their sides.
class Divider {
  public:
    Divider(WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
            const std::vector<Corner>& corners)
        : mesh_(mesh) {
        for (auto first = corners.begin(); first != corners.end();) {
            auto last = first;
            Side side{.face = edges[first->edge].face_a, .p = edges[first->edge].p, .within = {}};
            for (; last != corners.end() && last->edge == first->edge; ++last)
                side.within.push_back(last->vertex);
            sides_.push_back(std::move(side));
            first = last;
        }
        std::ranges::stable_sort(sides_, {}, &Side::face);
    }

    void divide() {
        std::vector<glm::uvec3> triangles = std::move(mesh_.triangles);
        const std::vector<std::uint32_t> group = std::move(mesh_.triangle_group),
                                         source = std::move(mesh_.triangle_source);
        mesh_.triangles.clear();
        mesh_.triangle_group.clear();
        mesh_.triangle_source.clear();
        auto side = sides_.begin();
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            std::array<std::vector<std::uint32_t>, 3> within;
            for (; side != sides_.end() && side->face == i; ++side)
                for (int k = 0; k < 3; ++k)
                    if (triangles[i][k] == side->p)
                        within[static_cast<std::size_t>(k)] = std::move(side->within);
            add(triangles[i], std::move(within));
            mesh_.triangle_group.resize(mesh_.triangles.size(), group[i]);
            mesh_.triangle_source.resize(mesh_.triangles.size(), source[i]);
        }
    }

  private:
    /// Corners within a side of a triangle, from its corner p on.
    struct Side {
        std::uint32_t face, p;
        std::vector<std::uint32_t> within;
    };

    /// `within[k]`: the corners within the side from corner k to the next.
    void add(glm::uvec3 t, std::array<std::vector<std::uint32_t>, 3> within) {
        const auto divided =
            std::ranges::find_if(within, [](const auto& one) { return !one.empty(); });
        if (divided == within.end()) {
            mesh_.triangles.push_back(t);
            return;
        }
        const auto by = static_cast<int>(divided - within.begin());
        std::ranges::rotate(within, divided);
        const std::uint32_t b = t[(by + 1) % 3], c = t[(by + 2) % 3];
        std::uint32_t from = t[by];
        std::vector<std::uint32_t> to_first = std::move(within[2]);
        for (const std::uint32_t vertex : within[0]) {
            add({from, vertex, c}, {{{}, {}, std::exchange(to_first, {})}});
            from = vertex;
        }
        add({from, b, c}, {{{}, std::move(within[1]), {}}});
    }

    WeldedMesh& mesh_;
    std::vector<Side> sides_;
};

} // namespace

std::size_t close_t_junctions(WeldedMesh& mesh, const std::vector<MeshEdge>& edges) {
    const std::vector<Corner> corners = Finder{mesh, edges}.find();
    if (!corners.empty()) Divider{mesh, edges, corners}.divide();
    return corners.size();
}

} // namespace lineatlas
