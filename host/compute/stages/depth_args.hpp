#pragma once

// Arguments of `depth`, and sizes of its tables.

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "core/screen_bounds.hpp"
#include "tables.hpp"

namespace lineatlas::compute {

/// The triangles of a model as `depth` draws them.
struct MeshletTables {
    Buffer& clusters;    ///< `Cluster` each
    Buffer& meshlets;    ///< `Meshlet` each
    Buffer& vertex_list; ///< uint32: the lists of all meshlets
    Buffer& corners;     ///< bytes: their triangles
    std::uint32_t count; ///< clusters
};

/// The depth of the triangles.
struct DepthArgs {
    MeshletTables model;
    Buffer& vertices; ///< as in SegmentTable
    glm::mat4 clip_from_world;
    glm::ivec2 whole_size;     ///< texels of the whole picture
    glm::ivec2 origin;         ///< the first texel of `depth` in it
    glm::ivec2 size;           ///< texels of `depth`
    TexelRectangle covered;    ///< the wanted texels; others may stay as they are
    Buffer& tiles;             ///< out: as of `pyramid`, for tiles with wanted texels
    Buffer& seen;              ///< out: a uint32 per cluster, 1 if any of it may be seen
    Buffer* depth = nullptr;   ///< out: as in DepthBuffer; null: nobody asks
    Buffer* numbers = nullptr; ///< out: as of SurfaceTables; null: nobody asks
    /// In and out: a byte per tile of `tiles`, 1 if the wanted ones of `depth` and `numbers` are
    /// known to show nothing there; null: nothing is known.
    Buffer* blank = nullptr;
};

/// Tiles of the depth pyramid per axis.
inline glm::ivec2 tiles_for(glm::ivec2 depth_size) {
    return (depth_size + (LA_TILE - 1)) / LA_TILE;
}

inline std::uint32_t count_of_tiles(glm::ivec2 depth_size) {
    const glm::ivec2 tiles = tiles_for(depth_size);
    return static_cast<std::uint32_t>(tiles.x) * static_cast<std::uint32_t>(tiles.y);
}

} // namespace lineatlas::compute
