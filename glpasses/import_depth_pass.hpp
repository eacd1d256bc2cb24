#pragma once

#include <glm/vec2.hpp>

#include "core/screen_bounds.hpp"
#include "core/standard_camera.hpp"
#include "objects.hpp"
#include "program.hpp"
#include "texel_copy.hpp"

namespace lineatlas::gl {

/// The kind of depth in `texture`. Throws UsageError if there is no texture of that name, or if it
/// is not a plain 2D depth texture with `size` texels from `origin` on. Call within a StateGuard,
/// because the texture stays bound.
DepthValues check_depth_texture(GLuint texture, glm::ivec2 origin, glm::ivec2 size);

/// `import_depth`: converts a program's own depth texture to window depth, in a texture of floats.
/// Values may lie outside of 0 to 1.
class ImportDepthPass {
  public:
    ImportDepthPass();

    /// Converts `part` of `size` texels from `origin` on.
    void draw(GLuint depth, glm::ivec2 origin, glm::ivec2 size, const TexelRectangle& part,
              const DepthMapping& mapping);
    /// As DepthPass::copy_to().
    void copy_to(GLuint buffer, const TexelRectangle& part);

    GLuint texture() const { return texture_.id(); }
    glm::ivec2 size() const { return size_; }

  private:
    void resize(glm::ivec2 size);

    Program program_;
    VertexArray vertex_array_; ///< without attributes
    Sampler sampler_;          ///< in place of the texture's own sampler, which may compare depths
    Framebuffer framebuffer_;
    TexelCopy copy_;
    Texture2D texture_;
    glm::ivec2 size_{0, 0};
};

} // namespace lineatlas::gl
