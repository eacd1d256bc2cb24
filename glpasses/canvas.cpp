#include "canvas.hpp"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

#include "lineatlas/error.hpp"
#include "storage.hpp"

namespace lineatlas::gl {

Canvas::Canvas(glm::ivec2 size, int bits, const Purpose& purpose)
    : size_(size), bits_(bits), texture_(Texture2D::create()), depth_(Renderbuffer::create()),
      framebuffer_(Framebuffer::create()) {
    if (size.x < 1 || size.y < 1) {
        throw UsageError("a picture of " + written_size(size) +
                         " can't be drawn: each side must have at least one pixel");
    }
    check_side(size, purpose);
    allocate(texture_, bits == 16 ? GL_RGBA16 : GL_RGBA8, size, purpose);
    allocate(depth_, GL_DEPTH_COMPONENT32F, size, purpose);
    glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, texture_.id(), 0);
    glNamedFramebufferRenderbuffer(framebuffer_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                   depth_.id());
}

void Canvas::clear(glm::vec4 color) {
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, glm::value_ptr(color));
}

void Canvas::clear_part(glm::ivec2 part) {
    glClearTexSubImage(texture_.id(), 0, 0, 0, 0, part.x, part.y, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                       nullptr);
}

std::vector<std::uint8_t> Canvas::read(glm::ivec2 part) const {
    const std::size_t row =
        static_cast<std::size_t>(part.x) * 4 * static_cast<std::size_t>(bits_ / 8);
    std::vector<std::uint8_t> pixels(row * static_cast<std::size_t>(part.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const int most_rows = rows_at_once(row);
    for (int low = 0; low < part.y; low += most_rows) {
        const int rows = std::min(part.y - low, most_rows);
        glGetTextureSubImage(texture_.id(), 0, 0, low, 0, part.x, rows, 1, GL_RGBA,
                             bits_ == 16 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE,
                             static_cast<GLsizei>(row * static_cast<std::size_t>(rows)),
                             pixels.data() + row * static_cast<std::size_t>(low));
    }
    const auto offset = [row](int y) {
        return static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y));
    };
    // GL's rows run from the bottom up.
    for (int top = 0, bottom = part.y - 1; top < bottom; ++top, --bottom) {
        std::swap_ranges(pixels.begin() + offset(top), pixels.begin() + offset(top + 1),
                         pixels.begin() + offset(bottom));
    }
    return pixels;
}

} // namespace lineatlas::gl
