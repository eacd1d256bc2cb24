#include "stroke_pass.hpp"

#include <cstddef>

#include "segment_table.h"

namespace lineatlas::gl {
namespace {

/// Attributes of one run, per vertex or per instance.
VertexArray run_array(GLuint divisor) {
    VertexArray array = VertexArray::create();
    for (GLuint attribute = 0; attribute < 5; ++attribute) {
        glEnableVertexArrayAttrib(array.id(), attribute);
        glVertexArrayAttribBinding(array.id(), attribute, 0);
    }
    glVertexArrayAttribFormat(array.id(), 0, 4, GL_FLOAT, GL_FALSE, offsetof(Run, start));
    glVertexArrayAttribFormat(array.id(), 1, 4, GL_FLOAT, GL_FALSE, offsetof(Run, start_corner));
    glVertexArrayAttribFormat(array.id(), 2, 4, GL_FLOAT, GL_FALSE, offsetof(Run, start_arc));
    glVertexArrayAttribIFormat(array.id(), 3, 4, GL_UNSIGNED_INT, offsetof(Run, address));
    glVertexArrayAttribFormat(array.id(), 4, 4, GL_FLOAT, GL_FALSE, offsetof(Run, stroke_start));
    glVertexArrayBindingDivisor(array.id(), 0, divisor);
    return array;
}

} // namespace

void PenTexture::bind(const Program& program, GLuint unit) const {
    glBindTextureUnit(unit, texture);
    program.set("pen", static_cast<int>(unit));
    program.set("pen_repeat", texture != 0 ? repeat_length : 0.0F);
}

void StrokeParams::bind(const Program& program, GLuint unit) const {
    glViewport(0, 0, static_cast<GLsizei>(viewport.x), static_cast<GLsizei>(viewport.y));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    pen.bind(program, unit);
    program.set("viewport", viewport);
    program.set("half_width", 0.5F * width);
    program.set("color", color);
}

StrokePass::StrokePass()
    : geometry_program_({"strokes.vert", "strokes.geom", "strokes.frag"}),
      vertex_program_({"strokes_quad.vert", "strokes.frag"}), point_array_(run_array(0)),
      quad_array_(run_array(1)) {}

void StrokePass::draw(const RunBuffers& runs, const StrokeParams& params) {
    // Made anew: the atlas may have grown into another buffer since the last frame.
    const TextureBuffer alpha = TextureBuffer::create();
    glTextureBuffer(alpha.id(), GL_R8, runs.alpha);

    const bool geometry = params.form == StrokeForm::geometry_shader;
    const Program& program = geometry ? geometry_program_ : vertex_program_;
    const VertexArray& array = geometry ? point_array_ : quad_array_;
    glBindTextureUnit(0, alpha.id());
    program.use();
    program.set("alpha", 0);
    program.set("join_kind", 0U);
    program.set("mitre_limit", 4.0F);
    program.set("cap_kinds", glm::uvec2{0, 1});
    params.bind(program, 1);
    glVertexArrayVertexBuffer(array.id(), 0, runs.runs, 0, sizeof(Run));
    glBindVertexArray(array.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, runs.record);
    if (geometry) {
        glDrawArraysIndirect(GL_POINTS,
                             reinterpret_cast<const void*>(offsetof(FrameRecord, points)));
    } else {
        glDrawArraysIndirect(GL_TRIANGLE_STRIP,
                             reinterpret_cast<const void*>(offsetof(FrameRecord, quads)));
    }
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glDisable(GL_BLEND);
}

} // namespace lineatlas::gl
