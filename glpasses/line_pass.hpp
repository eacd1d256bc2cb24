#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "depth_pass.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// Line end points on the GL side.
struct LineBuffers {
    GLuint vertices; ///< 3 floats each
    GLuint indices;  ///< 2 uint32 per line
    std::uint32_t line_count;
};

/// `opengl`, the usual way. Draws polygons into the depth buffer of the framebuffer, pushed back by
/// a slope-scaled offset, then line primitives under the depth test (§2, §5 OGL).
class LinePass {
  public:
    LinePass();

    /// Draws the depth of the triangles into `framebuffer`, which needs a depth attachment. Clears
    /// the depth of the viewport.
    void draw_depth(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                    glm::ivec2 origin, glm::ivec2 viewport, GLuint framebuffer);
    /// Draws the lines over what draw_depth() left. `width` in pixels, within what GL allows.
    void draw_lines(const LineBuffers& lines, const glm::mat4& clip_from_world, float width,
                    glm::vec4 color);

  private:
    Program depth_program_;
    Program line_program_;
    VertexArray vertex_array_;
    float widest_line_ = 1;
};

} // namespace lineatlas::gl
