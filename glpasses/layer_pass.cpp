#include "layer_pass.hpp"

#include <cstdint>
#include <utility>

#include <glm/common.hpp>

#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {

LayerPass::LayerPass()
    : program_({"layer.vert", "layer.frag"}), vertex_array_(VertexArray::create()) {}

void LayerPass::make_room(glm::ivec2 size) {
    size = glm::max(size, size_); // so that tiles of all sizes fit
    if (size == size_) return;
    Texture2D texture = Texture2D::create();
    allocate(texture, GL_RGBA8, size, purpose::picture);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    texture_ = std::move(texture);
    size_ = size;
}

void LayerPass::draw(GLuint pixels, glm::ivec2 size, const TexelRectangle& part, GLuint framebuffer,
                     glm::ivec2 origin) {
    const glm::ivec2 drawn = part.size();
    if (drawn.x <= 0 || drawn.y <= 0) return;
    make_room(size);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, pixels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, size.x);
    const std::size_t first =
        static_cast<std::size_t>(part.low.y) * static_cast<std::size_t>(size.x) +
        static_cast<std::size_t>(part.low.x);
    glTextureSubImage2D(texture_.id(), 0, part.low.x, part.low.y, drawn.x, drawn.y, GL_RGBA,
                        GL_UNSIGNED_BYTE,
                        reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);

    program_.use();
    const glm::vec2 whole{size_};
    program_.set("part", glm::vec4{glm::vec2{drawn} / whole, glm::vec2{part.low} / whole});
    lay(program_, texture_.id(), part, framebuffer, origin);
}

void LayerPass::draw_mean(const Canvas& canvas, int scale, glm::ivec2 size, GLuint framebuffer,
                          glm::ivec2 origin) {
    if (!mean_program_)
        mean_program_.emplace(std::vector<std::string_view>{"layer.vert", "layer.frag"}, "MEAN");
    mean_program_->use();
    mean_program_->set("scale", scale);
    mean_program_->set("steps", canvas.bits() == 16 ? 65535.0F : 255.0F);
    mean_program_->set("origin", origin);
    lay(*mean_program_, canvas.texture(), {{0, 0}, size}, framebuffer, origin);
}

void LayerPass::lay(const Program& program, GLuint texture, const TexelRectangle& part,
                    GLuint framebuffer, glm::ivec2 origin) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    set_viewport(origin + part.low, part.size());
    glDisable(GL_DEPTH_TEST);
    glEnablei(GL_BLEND, 0);
    glBlendEquationi(0, GL_FUNC_ADD);
    glBlendFunci(0, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindTextureUnit(0, texture);
    program.set("pixels", 0);
    glBindVertexArray(vertex_array_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisablei(GL_BLEND, 0);
}

} // namespace lineatlas::gl
