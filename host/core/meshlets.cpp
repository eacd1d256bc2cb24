#include "meshlets.hpp"

#include <stdexcept>

namespace lineatlas {
namespace {

/// Fills a list up with copies of its last element, if it has one.
template <class T>
void fill_up(std::vector<T>& list) {
    while (list.size() % LA_MESHLET_PADDING != 0) list.push_back(list.back());
}

} // namespace

Meshlets build_meshlets(std::span<const glm::uvec3> triangles, std::span<const Cluster> clusters,
                        std::size_t vertex_count) {
    Meshlets result;
    result.meshlets.reserve(clusters.size());
    result.corners.reserve(triangles.size() * 3 + clusters.size() * LA_MESHLET_PADDING);
    // The place of each vertex in the list of the last cluster that used the vertex.
    constexpr std::uint32_t none = 0xFFFFFFFF;
    std::vector<std::uint32_t> met_by(vertex_count, none);
    std::vector<std::uint8_t> places(vertex_count);
    for (std::uint32_t i = 0; i < clusters.size(); ++i) {
        const auto own = triangles.subspan(clusters[i].first, clusters[i].count);
        if (own.size() > LA_MESHLET_TRIANGLES) {
            throw std::length_error("a meshlet can't hold so many triangles");
        }
        Meshlet meshlet{.vertices = static_cast<std::uint32_t>(result.vertices.size()),
                        .vertex_count = 0,
                        .corners = static_cast<std::uint32_t>(result.corners.size()),
                        .triangle_count = static_cast<std::uint32_t>(own.size())};
        for (int corner = 0; corner < 3; ++corner) {
            for (const glm::uvec3& triangle : own) {
                const std::uint32_t vertex = triangle[corner];
                if (met_by[vertex] != i) {
                    met_by[vertex] = i;
                    places[vertex] = static_cast<std::uint8_t>(meshlet.vertex_count++);
                    result.vertices.push_back(vertex);
                }
                result.corners.push_back(places[vertex]);
            }
            fill_up(result.corners);
        }
        fill_up(result.vertices);
        result.meshlets.push_back(meshlet);
    }
    return result;
}

} // namespace lineatlas
