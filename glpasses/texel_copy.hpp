#pragma once

#include <glm/vec2.hpp>

#include "core/screen_bounds.hpp"
#include "current_context.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// Copies parts of textures to buffers. If GL has a GPU, a shader copies: on an NVIDIA H100 the
/// driver's own copy of 2048x1536 texels took 0.45 ms and the shader 0.03 ms.
class TexelCopy {
  public:
    explicit TexelCopy(bool by_shader = !is_software());

    /// Copies a rectangle of a texture of `size` texels to its place in a buffer for the whole
    /// texture, rows from the lower left. `format`: GL_DEPTH_COMPONENT, GL_RED or GL_RED_INTEGER;
    /// `type`: of 4 bytes.
    void copy(GLuint texture, GLenum format, GLenum type, glm::ivec2 size,
              const TexelRectangle& part, GLuint buffer);

  private:
    void copy_by_shader(GLuint texture, GLenum format, glm::ivec2 size, const TexelRectangle& part,
                        GLuint buffer);

    bool by_shader_;
    ProgramVariants programs_{{"copy_texels.comp"}};
};

} // namespace lineatlas::gl
