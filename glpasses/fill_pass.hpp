#pragma once

#include <cstdint>
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

struct FillView {
    glm::mat4 clip_from_world;
    glm::mat4 eye_from_world;
    glm::ivec2 viewport;
    glm::ivec2 origin{0, 0};        ///< its lower left corner in the framebuffer
    glm::vec4 tile = whole_picture; ///< tile_transform(): `viewport` is a part of the picture
};

/// `fill`: the triangles with their colours, flat or lit, under the lines.
class FillPass {
  public:
    FillPass();

    /// Draws these pieces of the list of triangles into `framebuffer`, which needs a depth
    /// attachment. Clears its depth. Throws DeviceError if GL cannot read so many colours.
    void draw(const TriangleBuffers& triangles, const TriangleColors& colors,
              std::span<const TriangleRange> ranges, const FillView& view, const Fill& fill,
              GLuint framebuffer);

  private:
    void set_light(const FillView& view, const Fill& fill) const;

    Program flat_program_;
    Program lit_program_;
    VertexArray vertex_array_;
    RangeCommands commands_;
    TextureBuffer indices_, table_; ///< views of the buffers of a draw
};

} // namespace lineatlas::gl
