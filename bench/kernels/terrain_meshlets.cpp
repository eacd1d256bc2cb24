#include "terrain_meshlets.hpp"

#include "core/clusters.hpp"
#include "core/meshlets.hpp"

namespace lineatlas::bench {

TerrainMesh make_terrain_mesh(std::uint32_t n) {
    const Terrain terrain = make_terrain(n, 0);
    TerrainMesh mesh{.vertices = {}, .triangles = {}, .clip_from_world = terrain.clip_from_world};
    for (std::size_t i = 0; i + 2 < terrain.vertices.size(); i += 3) {
        mesh.vertices.emplace_back(terrain.vertices[i], terrain.vertices[i + 1],
                                   terrain.vertices[i + 2]);
    }
    for (std::size_t i = 0; i < n; ++i) {
        mesh.triangles.emplace_back(terrain.triangles[3 * i], terrain.triangles[3 * i + 1],
                                    terrain.triangles[3 * i + 2]);
    }
    return mesh;
}

TerrainMeshlets::TerrainMeshlets(compute::Device& device, const TerrainMesh& mesh)
    : vertices(to_device(device, mesh.vertices)), clip_from_world(mesh.clip_from_world) {
    const TriangleClusters parts =
        build_clusters(mesh.vertices, mesh.triangles, LA_MESHLET_TRIANGLES);
    const Meshlets built = build_meshlets(parts.triangles, parts.clusters, mesh.vertices.size());
    clusters = to_device(device, parts.clusters);
    meshlets = to_device(device, built.meshlets);
    vertex_list = to_device(device, built.vertices);
    corners = to_device(device, built.corners);
    count = static_cast<std::uint32_t>(parts.clusters.size());
}

} // namespace lineatlas::bench
