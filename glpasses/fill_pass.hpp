#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "depth_pass.hpp"
#include "lineatlas/style.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// The colours of a list of triangles.
struct TriangleColors {
    GLuint indices = 0;  ///< into `colors`, per triangle; 0: no triangle has a colour
    GLenum index_format; ///< GL_R8UI or GL_R16UI
    GLuint colors;       ///< RGBA, 8 bits per channel; alpha 0: no colour
};

/// Triangles that are lit by normals of their corners.
struct SmoothTriangles {
    GLuint corners; ///< 3 uint32 per triangle of the list: of `normals`, or LA_NO_SURFACE
    GLuint normals; ///< `ContourCorner` each
    std::uint32_t normal_count, vertex_count;
};

struct FillView {
    glm::mat4 clip_from_world;
    glm::mat4 eye_from_world;
    glm::ivec2 viewport;
    glm::vec4 tile = whole_picture; ///< tile_transform(): `viewport` is a part of the picture
};

/// `fill`: the triangles with their colours, flat or lit, under the lines.
class FillPass {
  public:
    FillPass();

    /// Draws these pieces of the list of triangles into the lower left corner of `framebuffer`,
    /// which needs a depth attachment; its depth is cleared there. Throws DeviceError if GL cannot
    /// read so many colours or normals.
    void draw(const TriangleBuffers& triangles, const TriangleColors& colors,
              const std::optional<SmoothTriangles>& smooth, std::span<const TriangleRange> ranges,
              const FillView& view, const Fill& fill, GLuint framebuffer);

  private:
    static void set_light(const Program& program, const FillView& view, const Fill& fill);
    void bind(const TriangleBuffers& triangles, const SmoothTriangles& smooth);

    Program flat_program_;
    Program lit_program_;
    std::optional<Program> smooth_program_; ///< made when first used
    VertexArray vertex_array_;
    RangeCommands commands_;
    TextureBuffer indices_, table_, corners_, normals_, vertices_; ///< views of those of a draw
};

} // namespace lineatlas::gl
