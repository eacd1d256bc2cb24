#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "core/screen_bounds.hpp"
#include "core/tiles.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// The triangles that hide lines, on the GL side.
struct TriangleBuffers {
    GLuint vertices; ///< 3 floats each
    GLuint indices;  ///< 3 uint32 per triangle
    std::uint32_t triangle_count;
};

/// A piece of a list of triangles.
struct TriangleRange {
    std::uint32_t first, count;
};

/// Copies a rectangle of a texture of `size` floats to its place in a buffer for all of it: rows
/// from the lower left. `format`: GL_DEPTH_COMPONENT or GL_RED.
void copy_texels(GLuint texture, GLenum format, glm::ivec2 size, const TexelRectangle& part,
                 GLuint buffer);

/// `depth`: draws triangles into a depth texture of its own, larger than the viewport by `scale`
/// per axis (§3.2). Without a polygon offset: probes know the planes of a line's own faces
/// (probe.glsl) and recognise them by their exact depth.
class DepthPass {
  public:
    DepthPass();

    /// Clears the depth and makes it the target of what follows.
    void begin(glm::ivec2 viewport, int scale);
    void draw(const TriangleBuffers& triangles, const glm::mat4& clip_from_world);
    /// Draws only these pieces of the list of triangles; `tile`: tile_transform().
    void draw_ranges(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                     std::span<const TriangleRange> ranges, glm::vec4 tile = whole_picture);

    /// Takes a rectangle of depth from its place in a buffer for all of it, in place of drawing.
    void load(GLuint buffer, glm::ivec2 size, const TexelRectangle& part);

    /// Copies a rectangle of the depth of the last draw to its place in a buffer for all of it:
    /// floats, rows from the lower left.
    void copy_to(GLuint buffer, const TexelRectangle& part) const;

    GLuint texture() const { return texture_.id(); }
    glm::ivec2 size() const { return size_; } ///< of the texture

  private:
    void resize(glm::ivec2 size);
    void bind(const TriangleBuffers& triangles, const glm::mat4& clip_from_world, glm::vec4 tile);

    Program program_;
    VertexArray vertex_array_;
    Framebuffer framebuffer_;
    Texture2D texture_;
    glm::ivec2 size_{0, 0};
    std::vector<GLsizei> counts_; ///< of the ranges being drawn
    std::vector<const void*> first_bytes_;
};

} // namespace lineatlas::gl
