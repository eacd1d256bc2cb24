#include "fill_pass.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {

FillPass::FillPass()
    : flat_program_({"fill.vert", "fill.frag"}), lit_program_({"fill.vert", "fill.frag"}, "LIT"),
      vertex_array_(VertexArray::create()), indices_(TextureBuffer::create()),
      table_(TextureBuffer::create()) {
    const GLuint array = vertex_array_.id();
    glEnableVertexArrayAttrib(array, 0);
    glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(array, 0, 0);
    RangeCommands::describe(vertex_array_, 1, 1);
}

void FillPass::set_light(const FillView& view, const Fill& fill) const {
    const float length = glm::length(fill.light);
    const glm::vec3 light = length > 0 ? fill.light / length : glm::vec3{0, 0, 1};
    const int steps = fill.mode == FillMode::toon ? std::max(fill.toon_steps, 2) : 0;
    lit_program_.set("eye_from_world", view.eye_from_world);
    lit_program_.set("light", glm::vec4{light, 0});
    lit_program_.set("ambient", std::clamp(fill.ambient, 0.0F, 1.0F));
    lit_program_.set("steps", static_cast<float>(steps));
}

void FillPass::draw(const TriangleBuffers& triangles, const TriangleColors& colors,
                    std::span<const TriangleRange> ranges, const FillView& view, const Fill& fill,
                    GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    set_viewport(view.origin, view.viewport);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisablei(GL_BLEND, 0);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    clear_depth(view.origin, view.viewport);

    if (!commands_.take(ranges, purpose::fill)) return;

    if (colors.indices != 0) {
        check_buffer_texture(triangles.triangle_count, purpose::fill);
        glTextureBuffer(indices_.id(), colors.index_format, colors.indices);
        glTextureBuffer(table_.id(), GL_RGBA8, colors.colors);
        glBindTextureUnit(0, indices_.id());
        glBindTextureUnit(1, table_.id());
    }
    const bool lit = fill.mode == FillMode::lambert || fill.mode == FillMode::toon;
    const Program& program = lit ? lit_program_ : flat_program_;
    program.use();
    program.set("color_indices", 0);
    program.set("colors", 1);
    program.set("has_colors", colors.indices != 0);
    program.set("plain_color", glm::vec4{fill.color, 1});
    program.set("clip_from_world", view.clip_from_world);
    program.set("tile", view.tile);
    if (lit) set_light(view, fill);

    glVertexArrayVertexBuffer(vertex_array_.id(), 0, triangles.vertices, 0, 3 * sizeof(float));
    glVertexArrayElementBuffer(vertex_array_.id(), triangles.indices);
    glBindVertexArray(vertex_array_.id());
    commands_.draw(vertex_array_, 1);
    glDisable(GL_DEPTH_TEST);
}

} // namespace lineatlas::gl
