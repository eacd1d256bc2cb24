#include "fill_pass.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {

FillPass::FillPass()
    : flat_program_({"fill.vert", "fill.frag"}), lit_program_({"fill.vert", "fill.frag"}, "LIT"),
      vertex_array_(VertexArray::create()), indices_(TextureBuffer::create()),
      table_(TextureBuffer::create()), corners_(TextureBuffer::create()),
      normals_(TextureBuffer::create()), vertices_(TextureBuffer::create()) {
    const GLuint array = vertex_array_.id();
    glEnableVertexArrayAttrib(array, 0);
    glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(array, 0, 0);
    RangeCommands::describe(vertex_array_, 1, 1);
}

void FillPass::set_light(const Program& program, const FillView& view, const Fill& fill) {
    const float length = glm::length(fill.light);
    const glm::vec3 light = length > 0 ? fill.light / length : glm::vec3{0, 0, 1};
    const int steps = fill.mode == FillMode::toon ? std::max(fill.toon_steps, 2) : 0;
    program.set("eye_from_world", view.eye_from_world);
    program.set("light", glm::vec4{light, 0});
    program.set("ambient", std::clamp(fill.ambient, 0.0F, 1.0F));
    program.set("steps", static_cast<float>(steps));
}

void FillPass::bind(const TriangleBuffers& triangles, const SmoothTriangles& smooth) {
    for (const std::uint64_t texels :
         {triangles.triangle_count, smooth.normal_count, smooth.vertex_count})
        check_buffer_texture(texels, purpose::fill);
    glTextureBuffer(corners_.id(), GL_RGB32UI, smooth.corners);
    glTextureBuffer(normals_.id(), GL_RGBA32UI, smooth.normals);
    glTextureBuffer(vertices_.id(), GL_RGB32F, triangles.vertices);
    glBindTextureUnit(2, corners_.id());
    glBindTextureUnit(3, normals_.id());
    glBindTextureUnit(4, vertices_.id());
}

void FillPass::draw(const TriangleBuffers& triangles, const TriangleColors& colors,
                    const std::optional<SmoothTriangles>& smooth,
                    std::span<const TriangleRange> ranges, const FillView& view, const Fill& fill,
                    GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    set_viewport({0, 0}, view.viewport);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisablei(GL_BLEND, 0);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    clear_depth({0, 0}, view.viewport);

    if (!commands_.take(ranges, purpose::fill)) return;

    if (colors.indices != 0) {
        check_buffer_texture(triangles.triangle_count, purpose::fill);
        glTextureBuffer(indices_.id(), colors.index_format, colors.indices);
        glTextureBuffer(table_.id(), GL_RGBA8, colors.colors);
        glBindTextureUnit(0, indices_.id());
        glBindTextureUnit(1, table_.id());
    }
    const bool lit = fill.mode == FillMode::lambert || fill.mode == FillMode::toon;
    const bool is_smooth = lit && smooth.has_value();
    if (is_smooth) bind(triangles, *smooth);
    if (is_smooth && !smooth_program_)
        smooth_program_.emplace(std::vector<std::string_view>{"fill.vert", "fill.frag"},
                                "LIT SMOOTH");
    const Program& program = is_smooth ? *smooth_program_ : lit ? lit_program_ : flat_program_;
    program.use();
    program.set("color_indices", 0);
    program.set("colors", 1);
    program.set("has_colors", colors.indices != 0);
    program.set("plain_color", glm::vec4{fill.color, 1});
    program.set("clip_from_world", view.clip_from_world);
    program.set("tile", view.tile);
    if (lit) set_light(program, view, fill);
    if (is_smooth) {
        program.set("smooth_corners", 2);
        program.set("normals", 3);
        program.set("vertices", 4);
        program.set("eye_from_normal",
                    glm::mat4{glm::transpose(glm::inverse(glm::mat3{view.eye_from_world}))});
        program.set("viewport", glm::vec2{view.viewport});
    }

    glVertexArrayVertexBuffer(vertex_array_.id(), 0, triangles.vertices, 0, 3 * sizeof(float));
    glVertexArrayElementBuffer(vertex_array_.id(), triangles.indices);
    glBindVertexArray(vertex_array_.id());
    commands_.draw(vertex_array_, 1);
    glDisable(GL_DEPTH_TEST);
}

} // namespace lineatlas::gl
