#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// The triangles that hide lines, on the GL side.
struct TriangleBuffers {
    GLuint vertices; ///< 3 floats each
    GLuint indices;  ///< 3 uint32 per triangle
    std::uint32_t triangle_count;
};

/// `depth`: draws triangles into a depth texture of its own, larger than the viewport by `scale` per
/// axis (§3.2). Without a polygon offset: probes know the planes of a line's own faces (probe.glsl) and
/// recognise them by their exact depth.
class DepthPass {
  public:
    DepthPass();

    void draw(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
              glm::ivec2 viewport, int scale);

    /// Copies the depth of the last draw into a buffer: floats, rows from the lower left.
    void copy_to(GLuint buffer) const;

    GLuint texture() const { return texture_.id(); }
    glm::ivec2 size() const { return size_; }

  private:
    void resize(glm::ivec2 size);

    Program program_;
    VertexArray vertex_array_;
    Framebuffer framebuffer_;
    Texture2D texture_;
    glm::ivec2 size_{0, 0};
};

} // namespace lineatlas::gl
