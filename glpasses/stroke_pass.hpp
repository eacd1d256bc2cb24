#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// Which shader turns a run into a quad (§4.4); both draw the same picture.
enum class StrokeForm { geometry_shader, vertex_shader };

/// A pen's mark as a texture: coverage, u along the stroke and v across it.
struct PenTexture {
    GLuint texture;          ///< 0: a solid mark
    float repeat_length = 1; ///< pixels on the screen that one repeat of the texture covers

    /// Binds the texture to `unit` and sets the uniforms of mark.glsl.
    void bind(const Program& program, GLuint unit) const;
};

struct StrokeParams {
    glm::vec2 viewport; ///< pixels
    float width;        ///< pixels
    glm::vec4 color;    ///< RGB and opacity
    PenTexture pen;
    StrokeForm form;

    /// Prepares GL for strokes over the bound framebuffer, with the pen on texture `unit`, and sets
    /// the uniforms that all stroke shaders have. Blending stays on.
    void bind(const Program& program, GLuint unit) const;
};

/// The visible runs on the GL side, as `compact` writes them.
struct RunBuffers {
    GLuint runs;   ///< `Run` each
    GLuint record; ///< `FrameRecord`, source of the indirect draw
    GLuint alpha;  ///< the segment atlas, one byte per texel
};

/// `strokes`: draws the visible runs over the bound framebuffer, premultiplied. How many there are
/// stays on the device: the draw is indirect.
class StrokePass {
  public:
    StrokePass();
    void draw(const RunBuffers& runs, const StrokeParams& params);

  private:
    Program geometry_program_;
    Program vertex_program_;
    VertexArray point_array_;
    VertexArray quad_array_;
};

} // namespace lineatlas::gl
