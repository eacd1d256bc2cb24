#pragma once

// Arguments of `fill`.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/screen_bounds.hpp"
#include "depth_args.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas::compute {

/// Triangles that are lit by normals of their corners; null: there are none.
struct SmoothTriangles {
    /// Per triangle in the order of the clusters three uint32: of `normals`, or LA_NO_SURFACE.
    Buffer* smooth_corners = nullptr;
    Buffer* normals = nullptr; ///< ContourTables::corners
};

/// The colours under the lines, of what a numbered depth buffer shows.
struct FillArgs {
    MeshletTables model;
    Buffer& vertices; ///< as in SegmentTable
    Buffer& seen;     ///< of `depth`
    Buffer* colors; ///< a uint32 per triangle in the order of the clusters: RGBA, 8 bits each, red
                    ///< lowest; alpha 0: it has none. Null: none has
    SmoothTriangles smooth{};     ///< if the fill is lit
    const Fill& fill;             ///< its mode is not none
    glm::mat4 clip_from_world{1}; ///< as what follows of the whole picture
    glm::vec2 first_texel{0};     ///< from -1 to 1, the middle of the first pixel's
    glm::vec2 texel_step{0};      ///< from one to the next
    glm::mat4 eye_from_world;
    glm::vec4 eye;       ///< Camera::eye()
    Buffer& shaded;      ///< out, of triangles that are seen: as colors
    Buffer& numbers;     ///< as of SurfaceTables
    int row;             ///< texels in a row of them
    glm::ivec2 origin;   ///< where the texels of the first pixel begin in them
    int scale;           ///< texels per pixel and axis
    glm::ivec2 size;     ///< of `pixels`
    TexelRectangle part; ///< of them what is wanted; the others stay as they are
    Buffer& pixels;      ///< out: premultiplied RGBA, rows from the lower left
};

} // namespace lineatlas::compute
