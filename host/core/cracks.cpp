#include "cracks.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>

#include "box_tree.hpp"
#include "diagonal.hpp"
#include "vertex_sets.hpp"

namespace lineatlas {
namespace {

constexpr double widest_crack = 1e-5; ///< share of the model's diagonal
constexpr double least_length = 20;   ///< cracks are wide at most a share of their edges: 1 over it

class CrackFinder {
  public:
    CrackFinder(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges)
        : mesh_(mesh), widest_(std::max(widest_crack * diagonal_of(mesh.vertices),
                                        2 * static_cast<double>(mesh.precision))) {
        for (const MeshEdge& edge : edges) {
            if (edge.face_count == 1 && distance(edge.p, edge.q) > least_length * widest_)
                boundaries_.push_back(edge);
        }
    }

    /// Vertices to merge, as pairs.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> run() const {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        std::vector<Bounds> middles;
        middles.reserve(boundaries_.size());
        for (const MeshEdge& edge : boundaries_) {
            const glm::vec3 middle = (mesh_.vertices[edge.p] + mesh_.vertices[edge.q]) * 0.5F;
            const auto reach = static_cast<float>(widest_);
            middles.push_back({middle - reach, middle + reach});
        }
        const BoxTree tree{middles};
        tree.visit_meeting_pairs([&](std::uint32_t i, std::uint32_t j) {
            const MeshEdge &a = boundaries_[i], &b = boundaries_[j];
            if (a.face_a == b.face_a) return; // a sliver's own sides
            if (meet(a.p, b.q) && meet(a.q, b.p)) {
                pairs.emplace_back(a.p, b.q);
                pairs.emplace_back(a.q, b.p);
            } else if (meet(a.p, b.p) && meet(a.q, b.q)) { // windings differ
                pairs.emplace_back(a.p, b.p);
                pairs.emplace_back(a.q, b.q);
            }
        });
        return pairs;
    }

  private:
    double distance(std::uint32_t a, std::uint32_t b) const {
        return glm::distance(glm::dvec3{mesh_.vertices[a]}, glm::dvec3{mesh_.vertices[b]});
    }
    std::ptrdiff_t object_of(std::uint32_t vertex) const {
        return std::ranges::upper_bound(mesh_.object_ends, vertex) - mesh_.object_ends.begin();
    }
    bool meet(std::uint32_t a, std::uint32_t b) const {
        return distance(a, b) <= widest_ && object_of(a) == object_of(b);
    }

    const WeldedMesh& mesh_;
    double widest_;
    std::vector<MeshEdge> boundaries_; ///< long enough ones
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

std::size_t close_cracks(WeldedMesh& mesh, const std::vector<MeshEdge>& edges) {
    const auto pairs = CrackFinder{mesh, edges}.run();
    if (pairs.empty()) return 0;
    VertexSets merged{mesh.vertices.size()};
    for (const auto& [a, b] : pairs) merged.unite(a, b);
    for (glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) triangle[corner] = merged.find(triangle[corner]);
    }
    for (std::vector<std::uint32_t>& polyline : mesh.polylines) {
        for (std::uint32_t& vertex : polyline) vertex = merged.find(vertex);
    }
    remove_collapsed(mesh);
    return pairs.size() / 2; // of each edge both ends
}

} // namespace lineatlas
