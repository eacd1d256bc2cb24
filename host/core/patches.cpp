#include "patches.hpp"

#include <algorithm>

#include "base/vertex_sets.hpp"
#include "pair_key.hpp"

namespace lineatlas {
namespace {

struct TriangleEdge {
    std::uint64_t key;
    std::uint32_t triangle;
};

std::vector<TriangleEdge> sorted_edges(std::span<const glm::uvec3> triangles) {
    std::vector<TriangleEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            edges.push_back({pair_key(triangles[i][k], triangles[i][(k + 1) % 3]), i});
        }
    }
    std::ranges::sort(edges, {}, [](const TriangleEdge& edge) {
        return std::pair{edge.key, edge.triangle};
    });
    return edges;
}

} // namespace

std::vector<std::uint32_t> smooth_patches(std::span<const glm::uvec3> triangles,
                                          std::span<const Segment> segments) {
    std::vector<std::uint64_t> borders; // edges
    std::vector<std::uint64_t> parted;  // pairs of triangles
    for (const Segment& segment : segments) {
        const std::uint32_t kind = segment.tag & LA_TAG_KIND_MASK;
        const bool goes_on = kind == LA_KIND_SILHOUETTE || kind == LA_KIND_TANGENT;
        if (goes_on || (1U << kind & LA_KINDS_WITHIN) != 0) continue;
        borders.push_back(pair_key(segment.p, segment.q));
        // A segment on a part of an edge has other ends than the edge.
        if (segment.face_b != LA_NO_FACE)
            parted.push_back(pair_key(segment.face_a, segment.face_b & LA_FACE_INDEX));
    }
    std::ranges::sort(borders);
    std::ranges::sort(parted);
    const std::vector<TriangleEdge> edges = sorted_edges(triangles);
    VertexSets patches{triangles.size()};
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first;
        while (end < edges.size() && edges[end].key == edges[first].key) ++end;
        if (end - first == 2 && !std::ranges::binary_search(borders, edges[first].key) &&
            !std::ranges::binary_search(parted,
                                        pair_key(edges[first].triangle, edges[first + 1].triangle)))
            patches.unite(edges[first].triangle, edges[first + 1].triangle);
        first = end;
    }
    std::vector<std::uint32_t> result(triangles.size());
    for (std::uint32_t i = 0; i < result.size(); ++i) result[i] = patches.find(i);
    return result;
}

} // namespace lineatlas
