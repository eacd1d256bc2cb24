#include "depth_pass.hpp"

namespace lineatlas::gl {
DepthPass::DepthPass()
    : program_({"depth.vert", "depth.frag"}), vertex_array_(VertexArray::create()),
      framebuffer_(Framebuffer::create()) {
    glEnableVertexArrayAttrib(vertex_array_.id(), 0);
    glVertexArrayAttribFormat(vertex_array_.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertex_array_.id(), 0, 0);
    glNamedFramebufferDrawBuffer(framebuffer_.id(), GL_NONE);
    glNamedFramebufferReadBuffer(framebuffer_.id(), GL_NONE);
}

void DepthPass::resize(glm::ivec2 size) {
    if (size == size_) return;
    texture_ = Texture2D::create();
    glTextureStorage2D(texture_.id(), 1, GL_DEPTH_COMPONENT32F, size.x, size.y);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glNamedFramebufferTexture(framebuffer_.id(), GL_DEPTH_ATTACHMENT, texture_.id(), 0);
    size_ = size;
}

void DepthPass::draw(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                     glm::ivec2 viewport, int scale) {
    resize(viewport * scale);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, size_.x, size_.y);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    const float far = 1.0F;
    glClearBufferfv(GL_DEPTH, 0, &far);
    if (triangles.triangle_count > 0) {
        glVertexArrayVertexBuffer(vertex_array_.id(), 0, triangles.vertices, 0, 3 * sizeof(float));
        glVertexArrayElementBuffer(vertex_array_.id(), triangles.indices);
        glBindVertexArray(vertex_array_.id());
        program_.use();
        program_.set("clip_from_world", clip_from_world);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.triangle_count * 3),
                       GL_UNSIGNED_INT, nullptr);
    }
    glDisable(GL_DEPTH_TEST);
}

void DepthPass::copy_to(GLuint buffer) const {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureImage(texture_.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                      static_cast<GLsizei>(size_.x * size_.y * sizeof(float)), nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

} // namespace lineatlas::gl
