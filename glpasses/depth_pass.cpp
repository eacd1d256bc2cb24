#include "depth_pass.hpp"

#include "segment_table.h"
#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {

DepthPass::DepthPass()
    : programs_({"depth.vert", "depth.frag"}), vertex_array_(VertexArray::create()),
      numbered_array_(VertexArray::create()), framebuffer_(Framebuffer::create()),
      numbered_framebuffer_(Framebuffer::create()) {
    for (const VertexArray* array : {&vertex_array_, &numbered_array_}) {
        glEnableVertexArrayAttrib(array->id(), 0);
        glVertexArrayAttribFormat(array->id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayAttribBinding(array->id(), 0, 0);
    }
    RangeCommands::describe(numbered_array_, 1, 1);
    for (const Framebuffer* framebuffer : {&framebuffer_, &numbered_framebuffer_}) {
        glNamedFramebufferDrawBuffer(framebuffer->id(), GL_NONE);
        glNamedFramebufferReadBuffer(framebuffer->id(), GL_NONE);
    }
}

void DepthPass::resize(glm::ivec2 size) {
    if (size == size_) return;
    Texture2D texture = Texture2D::create();
    allocate(texture, GL_DEPTH_COMPONENT32F, size, purpose::depth);
    texture_ = std::move(texture);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glNamedFramebufferTexture(framebuffer_.id(), GL_DEPTH_ATTACHMENT, texture_.id(), 0);
    glNamedFramebufferTexture(numbered_framebuffer_.id(), GL_DEPTH_ATTACHMENT, texture_.id(), 0);
    size_ = size;
}

void DepthPass::resize_numbers(glm::ivec2 size) {
    if (size == numbers_size_) return;
    Texture2D texture = Texture2D::create();
    allocate(texture, GL_R32UI, size, purpose::depth);
    numbers_ = std::move(texture);
    glTextureParameteri(numbers_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(numbers_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glNamedFramebufferTexture(numbered_framebuffer_.id(), GL_COLOR_ATTACHMENT0, numbers_.id(), 0);
    glNamedFramebufferDrawBuffer(numbered_framebuffer_.id(), GL_COLOR_ATTACHMENT0);
    numbers_size_ = size;
}

void DepthPass::begin(glm::ivec2 viewport, int scale, bool numbered) {
    resize(viewport * scale);
    numbered_ = numbered;
    const float far = 1.0F;
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &far);
    if (!numbered) return;
    resize_numbers(size_);
    const GLuint none[4] = {LA_NO_FACE, LA_NO_FACE, LA_NO_FACE, LA_NO_FACE};
    glClearNamedFramebufferuiv(numbered_framebuffer_.id(), GL_COLOR, 0, none);
}

void DepthPass::bind(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                     glm::vec4 tile) {
    glBindFramebuffer(GL_FRAMEBUFFER, numbered_ ? numbered_framebuffer_.id() : framebuffer_.id());
    set_viewport({0, 0}, size_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisablei(GL_BLEND, 0);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    const VertexArray& array = numbered_ ? numbered_array_ : vertex_array_;
    glVertexArrayVertexBuffer(array.id(), 0, triangles.vertices, 0, 3 * sizeof(float));
    glVertexArrayElementBuffer(array.id(), triangles.indices);
    glBindVertexArray(array.id());
    const Program& program = programs_.with(numbered_ ? "NUMBERED" : "");
    program.use();
    program.set("clip_from_world", clip_from_world);
    program.set("tile", tile);
}

void DepthPass::draw(const TriangleBuffers& triangles, const glm::mat4& clip_from_world) {
    if (triangles.triangle_count == 0) return;
    if (numbered_) {
        const TriangleRange all{0, triangles.triangle_count};
        return draw_ranges(triangles, clip_from_world, {&all, 1});
    }
    bind(triangles, clip_from_world, whole_picture);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.triangle_count * 3),
                   GL_UNSIGNED_INT, nullptr);
    glDisable(GL_DEPTH_TEST);
}

void DepthPass::draw_ranges(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                            std::span<const TriangleRange> ranges, glm::vec4 tile) {
    if (ranges.empty()) return;
    bind(triangles, clip_from_world, tile);
    if (numbered_) {
        if (commands_.take(ranges, purpose::depth)) commands_.draw(numbered_array_, 1);
        glDisable(GL_DEPTH_TEST);
        return;
    }
    counts_.clear();
    first_bytes_.clear();
    for (const TriangleRange& range : ranges) {
        counts_.push_back(static_cast<GLsizei>(range.count * 3));
        const std::uintptr_t offset = std::uintptr_t{range.first} * 3 * sizeof(std::uint32_t);
        first_bytes_.push_back(reinterpret_cast<const void*>(offset));
    }
    glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, first_bytes_.data(),
                        static_cast<GLsizei>(ranges.size()));
    glDisable(GL_DEPTH_TEST);
}

void DepthPass::load_numbers(GLuint buffer, glm::ivec2 size, const TexelRectangle& part) {
    resize_numbers(size);
    const glm::ivec2 texels = part.size();
    if (texels.x <= 0 || texels.y <= 0) return;
    const std::size_t first =
        static_cast<std::size_t>(part.low.y) * static_cast<std::size_t>(size.x) +
        static_cast<std::size_t>(part.low.x);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, size.x);
    glTextureSubImage2D(numbers_.id(), 0, part.low.x, part.low.y, texels.x, texels.y,
                        GL_RED_INTEGER, GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(first * sizeof(la_uint)));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

void DepthPass::copy_to(GLuint buffer, const TexelRectangle& part) {
    copy_.copy(texture_.id(), GL_DEPTH_COMPONENT, GL_FLOAT, size_, part, buffer);
}

void DepthPass::copy_numbers_to(GLuint buffer, const TexelRectangle& part) {
    copy_.copy(numbers_.id(), GL_RED_INTEGER, GL_UNSIGNED_INT, numbers_size_, part, buffer);
}

} // namespace lineatlas::gl
