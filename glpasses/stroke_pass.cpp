#include "stroke_pass.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "segment_table.h"
#include "viewport.hpp"

namespace lineatlas::gl {
namespace {

/// A vertex array with one run per vertex.
VertexArray run_array() {
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
    return array;
}

// The longest mitre of any turn that is joined (LA_JOIN_LIMIT_COSINE).
constexpr float longest_mitre = 4;

float largest(std::span<const float> profile) {
    return *std::ranges::max_element(profile);
}

/// Whether a profile has any effect.
bool varies(std::span<const float> profile) {
    return profile.size() != 1 || profile[0] != 1.0F;
}

/// Lists the features that a style needs of the shader (strokes.frag). Fewer features make a
/// cheaper shader.
void list_features(const StrokeParams& params, const StrokeStyle& style, bool density,
                   std::string& names) {
    const auto has_cap = [&](Cap cap) { return style.cap == cap || style.path_cap == cap; };
    const bool fades = style.cap == Cap::butt && style.path_cap == Cap::round;
    const bool other_far = style.focus && style.focus->far_pen.texture != params.pen.texture;
    const bool far_texture = other_far && style.focus->far_pen.texture != 0;
    const std::pair<const char*, bool> all[] = {
        {"EXACT_ENDS", style.exact_ends || style.hidden || !fades},
        {"BEVELS", style.join == Join::bevel ||
                       (style.join == Join::mitre && style.mitre_limit < longest_mitre)},
        {"TAPERS", has_cap(Cap::taper)},
        {"DRY_CAPS", has_cap(Cap::texture)},
        {"WIDTH_PROFILE", varies(style.width_profile)},
        {"OPACITY_PROFILE", varies(style.opacity_profile)},
        {"DENSITY", density},
        {"FOCUS", style.focus.has_value()},
        {"FAR_TEXTURE", far_texture},
        {"FAR_SOLID", other_far && !far_texture},
        {"HIDDEN", style.hidden},
        {"PENS", style.only_pen.has_value()},
        {"PEN_TEXTURE", params.pen.texture != 0},
    };
    names.clear();
    for (const auto& [name, used] : all) {
        if (used) names.append(name).append(" ");
    }
}

void set_style(const Program& program, const StrokeParams& params, const StrokeStyle& style) {
    const float far_width = style.focus ? style.focus->far_width : 1;
    const float widest = largest(style.width_profile) * std::max(1.0F, far_width);
    program.set("half_width", 0.5F * params.width * widest);
    program.set("pen_half_width", 0.5F * params.width);
    program.set("join_kind", static_cast<unsigned>(style.join));
    program.set("mitre_limit", style.mitre_limit);
    program.set("cap_kinds", glm::uvec2{static_cast<unsigned>(style.cap),
                                        static_cast<unsigned>(style.path_cap)});
    program.set("cap_length", std::max(style.cap_length, 1e-3F));
    program.set("width_profile", style.width_profile);
    program.set("opacity_profile", style.opacity_profile);
    program.set("profile_counts",
                glm::uvec2{style.width_profile.size(), style.opacity_profile.size()});
    if (style.cap_grain.texture != 0) glBindTextureUnit(2, style.cap_grain.texture);
    program.set("cap_grain", 2);
    program.set("cap_grain_repeat", style.cap_grain.repeat_length);
    if (style.only_pen) program.set("only_pen", *style.only_pen);
    if (!style.focus) return;
    const FocusParams& focus = *style.focus;
    if (focus.far_pen.texture != 0) glBindTextureUnit(3, focus.far_pen.texture);
    program.set("far_pen", 3);
    program.set("far_pen_repeat", focus.far_pen.repeat_length);
    program.set("focus_in_scene", focus.in_scene);
    program.set("focus_point", glm::vec4{focus.point, 1});
    program.set("focus_range", glm::vec2{focus.radius, focus.falloff});
    program.set("far_width", focus.far_width);
    program.set("far_opacity", focus.far_opacity);
    program.set("world_from_clip", focus.world_from_clip);
}

} // namespace

void PenTexture::bind(const Program& program, GLuint unit) const {
    // Binding texture 0 would unbind textures of every kind that the program around has on the
    // unit.
    if (texture != 0) glBindTextureUnit(unit, texture);
    program.set("pen", static_cast<int>(unit));
    program.set("pen_repeat", repeat_length);
}

void StrokeParams::bind(const Program& program, GLuint unit) const {
    set_viewport(origin, tile.size);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnablei(GL_BLEND, 0);
    glBlendEquationi(0, GL_FUNC_ADD);
    glBlendFunci(0, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    pen.bind(program, unit);
    program.set("viewport", viewport);
    program.set("tile", glm::vec4{tile.low, tile.size});
    program.set("half_width", 0.5F * width);
    program.set("color", color);
}

StrokePass::StrokePass()
    : programs_({"strokes.vert", "strokes.geom", "strokes.frag"}), array_(run_array()),
      alpha_(TextureBuffer::create()), weights_(TextureBuffer::create()) {}

void StrokePass::draw(const RunBuffers& runs, const StrokeParams& params, const StrokeStyle& style,
                      const DensityWeights& density) {
    // Done in every draw, because buffers may have grown and been replaced since the last one.
    glTextureBuffer(alpha_.id(), GL_R8, runs.alpha);

    list_features(params, style, density.buffer != 0, features_);
    const Program& program = programs_.with(features_);
    glBindTextureUnit(0, alpha_.id());
    program.use();
    program.set("alpha", 0);
    params.bind(program, 1);
    set_style(program, params, style);
    if (density.buffer != 0) {
        glTextureBuffer(weights_.id(), GL_R32F, density.buffer);
        glBindTextureUnit(4, weights_.id());
        program.set("weights", 4);
        program.set("cells", glm::vec2{density.cells});
        program.set("cell_size", density.cell);
    }
    glVertexArrayVertexBuffer(array_.id(), 0, runs.runs, 0, sizeof(Run));
    glBindVertexArray(array_.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, runs.record);
    glDrawArraysIndirect(GL_POINTS, reinterpret_cast<const void*>(offsetof(FrameRecord, points)));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glDisablei(GL_BLEND, 0);
}

} // namespace lineatlas::gl
