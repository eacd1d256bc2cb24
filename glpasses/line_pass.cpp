#include "line_pass.hpp"

#include <algorithm>

#include "viewport.hpp"

namespace lineatlas::gl {
namespace {

constexpr float slope_factor = 1.0F;
constexpr float constant_units = 1.0F;

} // namespace

LinePass::LinePass()
    : depth_program_({"depth.vert", "depth.frag"}), line_program_({"lines.vert", "lines.frag"}),
      vertex_array_(VertexArray::create()) {
    glEnableVertexArrayAttrib(vertex_array_.id(), 0);
    glVertexArrayAttribFormat(vertex_array_.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertex_array_.id(), 0, 0);
    GLfloat range[2] = {1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
    widest_line_ = range[1];
}

void LinePass::draw_depth(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                          glm::ivec2 origin, glm::ivec2 viewport, GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    set_viewport(origin, viewport);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisablei(GL_BLEND, 0);
    glDisable(GL_CULL_FACE);
    clear_depth(origin, viewport);
    if (triangles.triangle_count == 0) return;
    glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(slope_factor, constant_units);
    glVertexArrayVertexBuffer(vertex_array_.id(), 0, triangles.vertices, 0, 3 * sizeof(float));
    glVertexArrayElementBuffer(vertex_array_.id(), triangles.indices);
    glBindVertexArray(vertex_array_.id());
    depth_program_.use();
    depth_program_.set("clip_from_world", clip_from_world);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.triangle_count * 3),
                   GL_UNSIGNED_INT, nullptr);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void LinePass::draw_lines(const LineBuffers& lines, const glm::mat4& clip_from_world, float width,
                          glm::vec4 color) {
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    // Opaque lines need no blending and do not pay for it.
    if (color.w < 1) {
        glEnablei(GL_BLEND, 0);
        glBlendEquationi(0, GL_FUNC_ADD);
        glBlendFunci(0, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
    if (lines.line_count > 0) {
        glLineWidth(std::clamp(width, 1.0F, widest_line_));
        glVertexArrayVertexBuffer(vertex_array_.id(), 0, lines.vertices, 0, 3 * sizeof(float));
        glVertexArrayElementBuffer(vertex_array_.id(), lines.indices);
        glBindVertexArray(vertex_array_.id());
        line_program_.use();
        line_program_.set("clip_from_world", clip_from_world);
        line_program_.set("color", color);
        glDrawElements(GL_LINES, static_cast<GLsizei>(lines.line_count * 2), GL_UNSIGNED_INT,
                       nullptr);
    }
    glDisablei(GL_BLEND, 0);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
}

} // namespace lineatlas::gl
