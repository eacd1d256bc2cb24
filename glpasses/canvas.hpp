#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/limits.hpp"
#include "objects.hpp"

namespace lineatlas::gl {

/// A picture to draw into, off screen: RGBA, premultiplied, with a depth buffer.
class Canvas {
  public:
    /// `bits` per channel: 8 or 16. Throws UsageError if the size exceeds what the device can draw.
    /// `purpose`: what the message says that memory is missing for.
    explicit Canvas(glm::ivec2 size, int bits = 8, const Purpose& purpose = purpose::picture);

    void clear(glm::vec4 color);
    /// Clears the colour of a part in the lower left corner: nothing is there.
    void clear_part(glm::ivec2 part);
    GLuint framebuffer() const { return framebuffer_.id(); }
    GLuint texture() const { return texture_.id(); } ///< its pixels, the lowest row first
    glm::ivec2 size() const { return size_; }
    int bits() const { return bits_; }
    /// Pixels from the top left, 4 values each; with 16 bits in native order.
    std::vector<std::uint8_t> read() const { return read(size_); }
    /// Pixels of a part in the lower left corner, in the same form.
    std::vector<std::uint8_t> read(glm::ivec2 part) const;

  private:
    glm::ivec2 size_;
    int bits_;
    Texture2D texture_;
    Renderbuffer depth_;
    Framebuffer framebuffer_;
};

} // namespace lineatlas::gl
