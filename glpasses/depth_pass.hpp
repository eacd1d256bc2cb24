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
#include "range_commands.hpp"
#include "texel_copy.hpp"

namespace lineatlas::gl {

/// The triangles that hide lines, on the GL side.
struct TriangleBuffers {
    GLuint vertices; ///< 3 floats each
    GLuint indices;  ///< 3 uint32 per triangle
    std::uint32_t triangle_count;
};

/// `depth`: draws triangles into a depth texture of its own, larger than the viewport by `scale`
/// per axis (§3.2). There is no polygon offset: probes know the planes of a line's own faces
/// (probe.glsl) and recognise the faces by their exact depth.
class DepthPass {
  public:
    DepthPass();

    /// Clears the depth and makes it the target of the calls that follow. `numbered`: each texel
    /// also gets the number of the triangle that it shows, in the order of the list of triangles.
    void begin(glm::ivec2 viewport, int scale, bool numbered = false);
    void draw(const TriangleBuffers& triangles, const glm::mat4& clip_from_world);
    /// Draws only these pieces of the list of triangles; `tile`: tile_transform().
    void draw_ranges(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                     std::span<const TriangleRange> ranges, glm::vec4 tile = whole_picture);

    /// Reads a rectangle of the numbers (uint32) from its place in a buffer for all of them, in
    /// place of drawing. There is no depth then.
    void load_numbers(GLuint buffer, glm::ivec2 size, const TexelRectangle& part);

    /// Copies a rectangle of the depth of the last draw to its place in a buffer for the whole
    /// depth: floats, rows from the lower left.
    void copy_to(GLuint buffer, const TexelRectangle& part);
    /// Copies a rectangle of the numbers in the same way: uint32, LA_NO_FACE where there is no
    /// triangle.
    void copy_numbers_to(GLuint buffer, const TexelRectangle& part);

    GLuint texture() const { return texture_.id(); }
    GLuint numbers() const { return numbers_.id(); }
    glm::ivec2 size() const { return size_; } ///< of the texture

  private:
    void resize(glm::ivec2 size);
    /// Makes the texture of numbers this large.
    void resize_numbers(glm::ivec2 size);
    void bind(const TriangleBuffers& triangles, const glm::mat4& clip_from_world, glm::vec4 tile);

    ProgramVariants programs_;
    VertexArray vertex_array_, numbered_array_;
    Framebuffer framebuffer_, numbered_framebuffer_;
    TexelCopy copy_;
    Texture2D texture_;
    Texture2D numbers_; ///< made when first asked for
    glm::ivec2 size_{0, 0}, numbers_size_{0, 0};
    bool numbered_ = false;       ///< the current drawing has numbers
    RangeCommands commands_;      ///< of numbered ranges
    std::vector<GLsizei> counts_; ///< of the ranges being drawn
    std::vector<const void*> first_bytes_;
};

} // namespace lineatlas::gl
