#pragma once

#include <glm/vec2.hpp>

#include "core/screen_bounds.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// Lays pixels that kernels drew over the picture.
class LayerPass {
  public:
    LayerPass();

    /// `pixels`: a buffer of `size` pixels in rows from the lower left: premultiplied RGBA, 8 bits
    /// per channel. Pixels in `part` are read and blended over `framebuffer`. `origin`: where all
    /// `size` pixels begin in the framebuffer. Throws DeviceError if the pixels are too many for a
    /// texture.
    void draw(GLuint pixels, glm::ivec2 size, const TexelRectangle& part, GLuint framebuffer,
              glm::ivec2 origin);

  private:
    void make_room(glm::ivec2 size);

    Program program_;
    VertexArray vertex_array_; ///< without attributes
    Texture2D texture_;
    glm::ivec2 size_{0, 0}; ///< of the texture
};

} // namespace lineatlas::gl
