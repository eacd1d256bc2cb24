#include "cracks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/vertex_sets.hpp"
#include "box_tree.hpp"
#include "diagonal.hpp"

namespace lineatlas {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// An edge of one triangle, from its end in the lesser cell to the other one.
struct Boundary {
    std::ptrdiff_t object;
    Cell cell_p, cell_q;
    std::uint32_t p, q, face;

    auto place() const { return std::tie(object, cell_p, cell_q); }
};

/// Finds boundaries that are one edge. All boundaries with both ends in the same cells are one
/// edge. Otherwise cells are compared with each other, and of two cells as many boundaries as it
/// takes to find two that are one.
class CrackCloser {
  public:
    CrackCloser(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges)
        : mesh_(mesh), widest_(widest_crack_of(mesh)), merged_(mesh.vertices.size()) {
        for (const MeshEdge& edge : edges) {
            if (edge.face_count == 1 && distance(edge.p, edge.q) > least_lengths_of_crack * widest_)
                boundaries_.push_back(boundary(edge));
        }
        std::ranges::stable_sort(boundaries_, [](const Boundary& a, const Boundary& b) {
            return a.place() < b.place();
        });
        one_edge_ = VertexSets{boundaries_.size()};
    }

    /// Returns how many boundaries became one edge with another.
    std::size_t run() {
        for (std::uint32_t first = 0; first < boundaries_.size();) {
            const std::uint32_t end = end_of(first, [&](const Boundary& one) {
                return one.object == boundaries_[first].object;
            });
            close_within_object(first, end);
            first = end;
        }
        return closed_;
    }

    VertexSets& merged() { return merged_; } ///< vertices

  private:
    /// Boundaries in the same cells that are one edge, or a single one.
    struct Group {
        std::uint32_t first, end;
    };

    double distance(std::uint32_t a, std::uint32_t b) const {
        return glm::distance(glm::dvec3{mesh_.vertices[a]}, glm::dvec3{mesh_.vertices[b]});
    }
    bool meet(std::uint32_t a, std::uint32_t b) const { return distance(a, b) <= widest_; }

    /// Two places in one cell are at most 0.87 of the widest crack apart.
    Cell cell(std::uint32_t vertex) const {
        const glm::dvec3 at = glm::floor(glm::dvec3{mesh_.vertices[vertex]} / (0.5 * widest_));
        return {static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y),
                static_cast<std::int64_t>(at.z)};
    }

    Boundary boundary(const MeshEdge& edge) const {
        Boundary result{.object = std::ranges::upper_bound(mesh_.object_ends, edge.p) -
                                  mesh_.object_ends.begin(),
                        .cell_p = cell(edge.p),
                        .cell_q = cell(edge.q),
                        .p = edge.p,
                        .q = edge.q,
                        .face = edge.face_a};
        if (result.cell_q < result.cell_p) {
            std::swap(result.cell_p, result.cell_q);
            std::swap(result.p, result.q);
        }
        return result;
    }

    template <class IsWithin>
    std::uint32_t end_of(std::uint32_t first, const IsWithin& is_within) const {
        std::uint32_t end = first + 1;
        while (end < boundaries_.size() && is_within(boundaries_[end])) ++end;
        return end;
    }

    void close_within_object(std::uint32_t first, std::uint32_t end) {
        std::vector<Group> groups;
        for (std::uint32_t i = first; i < end;) {
            const std::uint32_t group_end = end_of(
                i, [&](const Boundary& one) { return one.place() == boundaries_[i].place(); });
            add_groups(i, group_end, groups);
            i = group_end;
        }
        std::vector<Bounds> boxes;
        boxes.reserve(groups.size());
        for (const Group& group : groups) boxes.push_back(box(group));
        const BoxTree tree{boxes};
        tree.visit_meeting_pairs(
            [&](std::uint32_t a, std::uint32_t b) { close(groups[a], groups[b]); });
    }

    /// Adds groups. The sides of one sliver are no crack, unless another boundary runs there.
    void add_groups(std::uint32_t first, std::uint32_t end, std::vector<Group>& groups) {
        const bool of_one_face =
            std::all_of(boundaries_.begin() + first, boundaries_.begin() + end,
                        [&](const Boundary& one) { return one.face == boundaries_[first].face; });
        if (of_one_face) {
            for (std::uint32_t i = first; i < end; ++i) groups.push_back({i, i + 1});
            return;
        }
        for (std::uint32_t i = first + 1; i < end; ++i) unite(first, i, false);
        groups.push_back({first, end});
    }

    Bounds box(const Group& group) const {
        Bounds result;
        for (std::uint32_t i = group.first; i < group.end; ++i) {
            const glm::vec3 middle =
                (mesh_.vertices[boundaries_[i].p] + mesh_.vertices[boundaries_[i].q]) * 0.5F;
            result.min = glm::min(result.min, middle);
            result.max = glm::max(result.max, middle);
        }
        const auto reach = static_cast<float>(widest_);
        return {result.min - reach, result.max + reach};
    }

    void close(const Group& one, const Group& other) {
        if (one_edge_.find(one.first) == one_edge_.find(other.first)) return;
        for (std::uint32_t i = one.first; i < one.end; ++i)
            for (std::uint32_t j = other.first; j < other.end; ++j)
                if (close(i, j)) return;
    }

    bool close(std::uint32_t i, std::uint32_t j) {
        const Boundary &a = boundaries_[i], &b = boundaries_[j];
        if (a.face == b.face) return false;
        const bool turned = meet(a.p, b.q) && meet(a.q, b.p);
        if (!turned && !(meet(a.p, b.p) && meet(a.q, b.q))) return false;
        unite(i, j, turned);
        return true;
    }

    /// `turned`: the beginning of one is the end of the other.
    void unite(std::uint32_t i, std::uint32_t j, bool turned) {
        const Boundary &a = boundaries_[i], &b = boundaries_[j];
        one_edge_.unite(i, j);
        merged_.unite(a.p, turned ? b.q : b.p);
        merged_.unite(a.q, turned ? b.p : b.q);
        ++closed_;
    }

    const WeldedMesh& mesh_;
    double widest_;
    std::vector<Boundary> boundaries_; ///< long enough ones, by place
    VertexSets one_edge_{0};           ///< of boundaries
    VertexSets merged_;
    std::size_t closed_ = 0;
};

void remove_collapsed(WeldedMesh& mesh) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        if (t.x == t.y || t.y == t.z || t.z == t.x) {
            ++mesh.odd.collapsed;
            continue;
        }
        mesh.triangles[count] = t;
        mesh.triangle_group[count] = mesh.triangle_group[i];
        mesh.triangle_source[count++] = mesh.triangle_source[i];
    }
    mesh.triangles.resize(count);
    mesh.triangle_group.resize(count);
    mesh.triangle_source.resize(count);
}

} // namespace

double widest_crack_of(const WeldedMesh& mesh) {
    constexpr double share = 1e-5; // of the model's diagonal
    return std::max(share * diagonal_of(mesh.vertices), 2 * mesh.precision);
}

std::size_t close_cracks(WeldedMesh& mesh, const std::vector<MeshEdge>& edges) {
    CrackCloser closer{mesh, edges};
    const std::size_t closed = closer.run();
    if (closed == 0) return 0;
    VertexSets& merged = closer.merged();
    for (glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) triangle[corner] = merged.find(triangle[corner]);
    }
    for (std::vector<std::uint32_t>& polyline : mesh.polylines) {
        for (std::uint32_t& vertex : polyline) vertex = merged.find(vertex);
    }
    remove_collapsed(mesh);
    return closed;
}

} // namespace lineatlas
