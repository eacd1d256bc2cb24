#pragma once

#include <string>

#include "glpasses/objects.hpp"
#include "glpasses/program.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

// A program that draws models by GL and embeds the renderer.
namespace lineatlas::test {

/// The setup of that program's depth buffer.
struct DepthSetup {
    std::string name; ///< only letters, digits and _, because GoogleTest demands it
    GLenum format = GL_DEPTH_COMPONENT32F;
    bool reversed = false, infinite = false;
    ClipControl clip{};
    glm::vec2 range{0, 1}; ///< glDepthRange()
    glm::ivec2 origin{0, 0};
    int scale = 1;
};

/// The camera with planes at `near` and `far` for this setup.
Camera app_camera(const Camera& camera, float near, float far, const DepthSetup& setup);

/// Distances of the planes of a symmetric perspective projection.
glm::vec2 planes_of(const Camera& camera);

/// A model, and its depth in a texture.
class AppScene {
  public:
    explicit AppScene(const LineSet& lines);

    /// Draws the depth. Leaves GL in its initial state.
    void draw_depth(const Camera& camera, const DepthSetup& setup);
    GLuint depth() const { return depth_.id(); }

  private:
    gl::Program program_;
    gl::VertexArray vertex_array_;
    gl::Buffer vertices_, indices_;
    gl::Texture2D depth_;
    gl::Framebuffer framebuffer_;
    GLsizei index_count_;
};

} // namespace lineatlas::test
