#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "depth_pass.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// A line as the item buffer draws it: its ends in normalised device coordinates, within the
/// frustum.
struct ItemLine {
    glm::vec3 p, q;
};

/// How fine an item buffer is.
struct ItemBufferShape {
    glm::ivec2 viewport;  ///< pixels
    int scale;            ///< texels per pixel and axis
    std::uint32_t layers; ///< lines that a texel can hold: 1 to 3

    glm::ivec2 size() const { return viewport * scale; }
    bool operator==(const ItemBufferShape&) const = default;
};

/// The ID images of a frame in host memory, the nearest layer first. A texel is 0 or the place of a
/// line in the list of lines, plus 1. Rows from the lower left.
struct ItemImages {
    std::array<const std::uint32_t*, 3> texels; ///< null beyond `layers`
    std::uint32_t layers;
    glm::ivec2 size;
    int line_width; ///< texels that a line covers in each column (or row) that it crosses
};

/// `item_buffer`: the ID reference image of Northrup & Markosian 2000, or the supersampled and
/// peeled one of Cole & Finkelstein 2008. Draws the polygons' depth, then every line with its ID in
/// place of a colour. Polygons are drawn with the slope-scaled offset of the published methods.
/// Supersampled lines are one pixel wide, not one texel, so that a face may hide a part of a line's
/// width.
class ItemBufferPass {
  public:
    static constexpr std::uint32_t max_layers = 3;

    ItemBufferPass();

    /// Memory of GL for `count` lines, to be filled before `draw`.
    std::span<ItemLine> map_lines(std::uint32_t count);
    /// Draws the lines and maps their ID images, which stay until `unmap_images`.
    ItemImages draw(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                    const ItemBufferShape& shape);
    void unmap_images();

  private:
    void resize(const ItemBufferShape& shape);
    void draw_polygons(const TriangleBuffers& triangles, const glm::mat4& clip_from_world);
    void draw_layer(std::uint32_t layer);

    struct Layer {
        Texture2D ids;
        Framebuffer framebuffer;
        Buffer readback;
    };

    Program polygon_program_, line_program_;
    VertexArray polygon_array_, line_array_;
    Framebuffer polygon_framebuffer_;
    Texture2D polygon_depth_, line_depth_;
    std::array<Layer, max_layers> layers_;
    Buffer lines_;
    std::uint32_t line_capacity_ = 0, line_count_ = 0;
    int widest_line_ = 1;
    ItemBufferShape shape_{{0, 0}, 1, 0};
};

} // namespace lineatlas::gl
