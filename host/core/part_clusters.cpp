#include "part_clusters.hpp"

#include <algorithm>
#include <numeric>

namespace lineatlas {
namespace {

constexpr Cluster no_cluster{.low = {0, 0, 0}, .high = {0, 0, 0}, .first = 0, .count = 0};

} // namespace

TriangleClusters part_clusters(std::uint32_t object, const PartRooms& rooms, const LineSet& part) {
    TriangleClusters result = build_clusters(part.vertices, part.triangles, LA_MESHLET_TRIANGLES);
    for (glm::uvec3& t : result.triangles) t += rooms.vertices.first;
    for (std::uint32_t& place : result.order) place += rooms.triangles.first;
    for (Cluster& cluster : result.clusters) cluster.first += rooms.triangles.first;
    while (result.order.size() < rooms.triangles.size)
        result.order.push_back(rooms.triangles.first +
                               static_cast<std::uint32_t>(result.order.size()));
    result.triangles.resize(rooms.triangles.size, glm::uvec3{0});
    result.clusters.resize(rooms.clusters.size, no_cluster);
    result.objects.assign(rooms.clusters.size, object);
    return result;
}

TriangleClusters all_part_clusters(const AssemblyState& parts) {
    TriangleClusters result;
    result.triangles.resize(parts.lines.triangles.size(), glm::uvec3{0});
    result.order.resize(result.triangles.size());
    std::iota(result.order.begin(), result.order.end(), 0U);
    result.clusters.resize(parts.cluster_count, no_cluster);
    result.objects.resize(parts.cluster_count, 0);
    for (std::uint32_t i = 0; i < parts.parts.size(); ++i) {
        if (!parts.parts[i].is_there) continue;
        const PartRooms& rooms = parts.parts[i].rooms;
        const TriangleClusters own = part_clusters(i, rooms, part_lines(parts, i));
        std::ranges::copy(own.triangles, result.triangles.begin() + rooms.triangles.first);
        std::ranges::copy(own.order, result.order.begin() + rooms.triangles.first);
        std::ranges::copy(own.clusters, result.clusters.begin() + rooms.clusters.first);
        std::ranges::copy(own.objects, result.objects.begin() + rooms.clusters.first);
    }
    return result;
}

Meshlets part_meshlets(const PartRooms& rooms, const TriangleClusters& clusters) {
    // With vertices counted within the part: a list of what has met all would cost more than it.
    const std::uint32_t vertex = rooms.vertices.first;
    std::vector<glm::uvec3> triangles = clusters.triangles;
    for (glm::uvec3& t : triangles) t -= vertex; // of those beyond the part nobody asks
    std::vector<Cluster> pieces = clusters.clusters;
    for (Cluster& piece : pieces)
        if (piece.count > 0) piece.first -= rooms.triangles.first;
    Meshlets result = build_meshlets(triangles, pieces, rooms.vertices.size);
    for (std::uint32_t& v : result.vertices) v += vertex;
    return spread_out(result, rooms.clusters.first);
}

Meshlets spread_out(const Meshlets& meshlets, std::uint32_t first) {
    constexpr std::uint32_t room = LA_MESHLET_VERTICES; // of either list
    const std::size_t count = meshlets.meshlets.size();
    Meshlets result{.meshlets = meshlets.meshlets,
                    .vertices = std::vector<std::uint32_t>(count * room),
                    .corners = std::vector<std::uint8_t>(count * room)};
    const auto filled_up = [](std::uint32_t size) {
        return (size + LA_MESHLET_PADDING - 1) / LA_MESHLET_PADDING * LA_MESHLET_PADDING;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Meshlet& from = meshlets.meshlets[i];
        const auto to = static_cast<std::ptrdiff_t>(i * room);
        std::copy_n(meshlets.vertices.begin() + from.vertices, filled_up(from.vertex_count),
                    result.vertices.begin() + to);
        std::copy_n(meshlets.corners.begin() + from.corners, 3 * filled_up(from.triangle_count),
                    result.corners.begin() + to);
        const auto place = (first + static_cast<std::uint32_t>(i)) * room;
        result.meshlets[i].vertices = result.meshlets[i].corners = place;
    }
    return result;
}

} // namespace lineatlas
