#include "state_guard.hpp"

#include <algorithm>

#include "lineatlas/error.hpp"

namespace lineatlas::gl {
namespace {

struct Capability {
    GLenum name;
    bool initial;
};

constexpr Capability capabilities[] = {
    {GL_DEPTH_TEST, false},
    {GL_STENCIL_TEST, false},
    {GL_CULL_FACE, false},
    {GL_COLOR_LOGIC_OP, false},
    {GL_DEPTH_CLAMP, false},
    {GL_FRAMEBUFFER_SRGB, false},
    {GL_LINE_SMOOTH, false},
    {GL_POLYGON_SMOOTH, false},
    {GL_POLYGON_OFFSET_FILL, false},
    {GL_POLYGON_OFFSET_LINE, false},
    {GL_POLYGON_OFFSET_POINT, false},
    {GL_PRIMITIVE_RESTART, false},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, false},
    {GL_RASTERIZER_DISCARD, false},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, false},
    {GL_SAMPLE_ALPHA_TO_ONE, false},
    {GL_SAMPLE_COVERAGE, false},
    {GL_SAMPLE_SHADING, false},
    {GL_SAMPLE_MASK, false},
    {GL_MULTISAMPLE, true},
    {GL_DITHER, true},
    {GL_CLIP_DISTANCE0, false},
    {GL_CLIP_DISTANCE1, false},
    {GL_CLIP_DISTANCE2, false},
    {GL_CLIP_DISTANCE3, false},
    {GL_CLIP_DISTANCE4, false},
    {GL_CLIP_DISTANCE5, false},
    {GL_CLIP_DISTANCE6, false},
    {GL_CLIP_DISTANCE7, false},
};

struct PixelStore {
    GLenum name;
    GLint initial;
};

constexpr PixelStore pixel_stores[] = {
    {GL_PACK_SWAP_BYTES, 0},   {GL_PACK_LSB_FIRST, 0},     {GL_PACK_ROW_LENGTH, 0},
    {GL_PACK_IMAGE_HEIGHT, 0}, {GL_PACK_SKIP_ROWS, 0},     {GL_PACK_SKIP_PIXELS, 0},
    {GL_PACK_SKIP_IMAGES, 0},  {GL_PACK_ALIGNMENT, 4},     {GL_UNPACK_SWAP_BYTES, 0},
    {GL_UNPACK_LSB_FIRST, 0},  {GL_UNPACK_ROW_LENGTH, 0},  {GL_UNPACK_IMAGE_HEIGHT, 0},
    {GL_UNPACK_SKIP_ROWS, 0},  {GL_UNPACK_SKIP_PIXELS, 0}, {GL_UNPACK_SKIP_IMAGES, 0},
    {GL_UNPACK_ALIGNMENT, 4},
};

GLint get(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLint get_first(GLenum name) {
    GLint value = 0;
    glGetIntegeri_v(name, 0, &value);
    return value;
}

void enable(GLenum capability, bool on) {
    if (on)
        glEnable(capability);
    else
        glDisable(capability);
}

void enable_first(GLenum capability, bool on) {
    if (on)
        glEnablei(capability, 0);
    else
        glDisablei(capability, 0);
}

/// Whether polygon offsets have a clamp, which glPolygonOffset() sets to 0.
bool has_offset_clamp() {
    return epoxy_gl_version() >= 46;
}

GLuint name(GLint id) {
    return static_cast<GLuint>(id);
}

} // namespace

StateGuard::StateGuard() {
    static_assert(std::size(capabilities) == capability_count);
    static_assert(std::size(pixel_stores) == pixel_store_count);
    take();
}

StateGuard::~StateGuard() {
    restore();
}

void StateGuard::take() {
    if (get(GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 && get(GL_TRANSFORM_FEEDBACK_PAUSED) == 0) {
        throw UsageError("renderer: a transform feedback is active; end or pause it first");
    }
    is_compatibility_ = is_compatibility();
    if (is_compatibility_) compatibility_.save(); // may throw
    save();
    set_initial();
}

void StateGuard::save() {
    for (std::size_t i = 0; i < enabled_.size(); ++i) {
        enabled_[i] = glIsEnabled(capabilities[i].name);
    }
    for (std::size_t i = 0; i < pixel_store_.size(); ++i) {
        pixel_store_[i] = get(pixel_stores[i].name);
    }
    program_ = get(GL_CURRENT_PROGRAM);
    vertex_array_ = get(GL_VERTEX_ARRAY_BINDING);
    draw_framebuffer_ = get(GL_DRAW_FRAMEBUFFER_BINDING);
    read_framebuffer_ = get(GL_READ_FRAMEBUFFER_BINDING);
    pack_buffer_ = get(GL_PIXEL_PACK_BUFFER_BINDING);
    unpack_buffer_ = get(GL_PIXEL_UNPACK_BUFFER_BINDING);
    indirect_buffer_ = get(GL_DRAW_INDIRECT_BUFFER_BINDING);
    query_buffer_ = get(GL_QUERY_BUFFER_BINDING);
    save_raster();
    save_blend();
    save_textures();
}

void StateGuard::save_raster() {
    glGetFloati_v(GL_VIEWPORT, 0, viewport_.data());
    glGetIntegeri_v(GL_SCISSOR_BOX, 0, scissor_.data());
    glGetDoublei_v(GL_DEPTH_RANGE, 0, depth_range_.data());
    scissor_test_ = glIsEnabledi(GL_SCISSOR_TEST, 0);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
    depth_func_ = get(GL_DEPTH_FUNC);
    clip_origin_ = get(GL_CLIP_ORIGIN);
    clip_depth_ = get(GL_CLIP_DEPTH_MODE);
    provoking_vertex_ = get(GL_PROVOKING_VERTEX);
    glGetIntegerv(GL_POLYGON_MODE, polygon_mode_.data());
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offset_factor_);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offset_units_);
    if (has_offset_clamp()) glGetFloatv(GL_POLYGON_OFFSET_CLAMP, &offset_clamp_);
    glGetFloatv(GL_LINE_WIDTH, &line_width_);
}

void StateGuard::save_blend() {
    blend_ = glIsEnabledi(GL_BLEND, 0);
    source_rgb_ = get_first(GL_BLEND_SRC_RGB);
    source_alpha_ = get_first(GL_BLEND_SRC_ALPHA);
    target_rgb_ = get_first(GL_BLEND_DST_RGB);
    target_alpha_ = get_first(GL_BLEND_DST_ALPHA);
    equation_rgb_ = get_first(GL_BLEND_EQUATION_RGB);
    equation_alpha_ = get_first(GL_BLEND_EQUATION_ALPHA);
    draw_buffers_ = std::min(get(GL_MAX_DRAW_BUFFERS), most_draw_buffers);
    for (int i = 0; i < draw_buffers_; ++i) {
        const auto index = static_cast<std::size_t>(i);
        glGetBooleani_v(GL_COLOR_WRITEMASK, name(i), color_masks_[index].data());
    }
}

void StateGuard::save_textures() {
    active_texture_ = get(GL_ACTIVE_TEXTURE);
    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        units_[i] = {.texture_2d = get(GL_TEXTURE_BINDING_2D),
                     .texture_buffer = get(GL_TEXTURE_BINDING_BUFFER),
                     .sampler = get(GL_SAMPLER_BINDING)};
    }
    glActiveTexture(GL_TEXTURE0);
}

void StateGuard::set_initial() {
    for (std::size_t i = 0; i < enabled_.size(); ++i) {
        const bool on = enabled_[i] != GL_FALSE;
        if (on != capabilities[i].initial) enable(capabilities[i].name, capabilities[i].initial);
    }
    for (std::size_t i = 0; i < pixel_store_.size(); ++i) {
        const auto& [store, initial] = pixel_stores[i];
        if (pixel_store_[i] != initial) glPixelStorei(store, initial);
    }
    if (pack_buffer_ != 0) glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    if (unpack_buffer_ != 0) glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    if (query_buffer_ != 0) glBindBuffer(GL_QUERY_BUFFER, 0);
    glDepthRangeIndexed(0, 0, 1);
    enable_first(GL_SCISSOR_TEST, false);
    enable_first(GL_BLEND, false);
    glDepthMask(GL_TRUE);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glLineWidth(1.0F);
    // Shaders write to the first draw buffer only, and others would get undefined values.
    for (int i = 0; i < draw_buffers_; ++i) {
        const GLboolean write = i == 0 ? GL_TRUE : GL_FALSE;
        glColorMaski(name(i), write, write, write, write);
    }
    for (std::size_t i = 0; i < units_.size(); ++i) {
        if (units_[i].sampler != 0) glBindSampler(static_cast<GLuint>(i), 0);
    }
    if (is_compatibility_) compatibility_.set_initial();
}

void StateGuard::restore() {
    for (std::size_t i = 0; i < enabled_.size(); ++i) {
        enable(capabilities[i].name, enabled_[i] != GL_FALSE);
    }
    for (std::size_t i = 0; i < pixel_store_.size(); ++i) {
        glPixelStorei(pixel_stores[i].name, pixel_store_[i]);
    }
    glUseProgram(name(program_));
    glBindVertexArray(name(vertex_array_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name(draw_framebuffer_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name(read_framebuffer_));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, name(pack_buffer_));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, name(unpack_buffer_));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, name(indirect_buffer_));
    glBindBuffer(GL_QUERY_BUFFER, name(query_buffer_));
    restore_raster();
    restore_blend();
    restore_textures();
    if (is_compatibility_) compatibility_.restore();
}

void StateGuard::restore_raster() const {
    glViewportIndexedfv(0, viewport_.data());
    glScissorIndexedv(0, scissor_.data());
    glDepthRangeIndexed(0, depth_range_[0], depth_range_[1]);
    enable_first(GL_SCISSOR_TEST, scissor_test_ != GL_FALSE);
    glDepthMask(depth_mask_);
    glDepthFunc(static_cast<GLenum>(depth_func_));
    glClipControl(static_cast<GLenum>(clip_origin_), static_cast<GLenum>(clip_depth_));
    glProvokingVertex(static_cast<GLenum>(provoking_vertex_));
    if (is_compatibility_) { // there is one mode for either side of a polygon
        glPolygonMode(GL_FRONT, static_cast<GLenum>(polygon_mode_[0]));
        glPolygonMode(GL_BACK, static_cast<GLenum>(polygon_mode_[1]));
    } else {
        glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygon_mode_[0]));
    }
    if (has_offset_clamp())
        glPolygonOffsetClamp(offset_factor_, offset_units_, offset_clamp_);
    else
        glPolygonOffset(offset_factor_, offset_units_);
    glLineWidth(line_width_);
}

void StateGuard::restore_blend() const {
    enable_first(GL_BLEND, blend_ != GL_FALSE);
    glBlendFuncSeparatei(0, static_cast<GLenum>(source_rgb_), static_cast<GLenum>(target_rgb_),
                         static_cast<GLenum>(source_alpha_), static_cast<GLenum>(target_alpha_));
    glBlendEquationSeparatei(0, static_cast<GLenum>(equation_rgb_),
                             static_cast<GLenum>(equation_alpha_));
    for (int i = 0; i < draw_buffers_; ++i) {
        const auto& mask = color_masks_[static_cast<std::size_t>(i)];
        glColorMaski(name(i), mask[0], mask[1], mask[2], mask[3]);
    }
}

void StateGuard::restore_textures() const {
    for (std::size_t i = 0; i < units_.size(); ++i) {
        const auto unit = static_cast<GLuint>(i);
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, name(units_[i].texture_2d));
        glBindTexture(GL_TEXTURE_BUFFER, name(units_[i].texture_buffer));
        glBindSampler(unit, name(units_[i].sampler));
    }
    glActiveTexture(static_cast<GLenum>(active_texture_));
}

} // namespace lineatlas::gl
