#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "canvas.hpp"
#include "core/screen_bounds.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// Lays what was drawn elsewhere over the picture.
class LayerPass {
  public:
    LayerPass();

    /// `pixels`: a buffer of `size` pixels in rows from the lower left: premultiplied RGBA, 8 bits
    /// per channel. Pixels in `part` are read and blended over `framebuffer`. `origin`: where all
    /// `size` pixels begin in the framebuffer. Throws DeviceError if the pixels are too many for a
    /// texture.
    void draw(GLuint pixels, glm::ivec2 size, const TexelRectangle& part, GLuint framebuffer,
              glm::ivec2 origin);

    /// The same from the lower left corner of a canvas, of which the mean of each `scale` by
    /// `scale` texels makes a pixel, rounded to as many bits. `size`: in pixels.
    void draw_mean(const Canvas& canvas, int scale, glm::ivec2 size, GLuint framebuffer,
                   glm::ivec2 origin);

  private:
    void make_room(glm::ivec2 size);
    void lay(const Program& program, GLuint texture, const TexelRectangle& part, GLuint framebuffer,
             glm::ivec2 origin);

    Program program_;
    std::optional<Program> mean_program_; ///< made when first used
    VertexArray vertex_array_;            ///< without attributes
    Texture2D texture_;
    glm::ivec2 size_{0, 0}; ///< of the texture
};

} // namespace lineatlas::gl
