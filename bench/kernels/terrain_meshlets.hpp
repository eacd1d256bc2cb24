#pragma once

#include <glm/vec3.hpp>

#include "terrain.hpp"

namespace lineatlas::bench {

/// A terrain as a mesh.
struct TerrainMesh {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    glm::mat4 clip_from_world;
};

/// A terrain with exactly n triangles.
TerrainMesh make_terrain_mesh(std::uint32_t n);

/// The tables of a TerrainMesh on a device, as `depth`, `planes` and `fill` take them.
struct TerrainMeshlets {
    TerrainMeshlets(compute::Device& device, const TerrainMesh& mesh);

    compute::MeshletTables tables() const {
        return {*clusters, *meshlets, *vertex_list, *corners, count};
    }

    SharedBuffer vertices, clusters, meshlets, vertex_list, corners;
    std::uint32_t count; ///< number of clusters
    glm::mat4 clip_from_world;
};

} // namespace lineatlas::bench
