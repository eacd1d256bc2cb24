#include "gl_state.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "glpasses/compatibility_state.hpp"

namespace lineatlas::test {
namespace {

struct Named {
    const char* name;
    GLenum value;
};
#define NAMED(x)                                                                                   \
    Named {                                                                                        \
#x, x                                                                                      \
    }

constexpr Named capabilities[] = {
    NAMED(GL_BLEND),
    NAMED(GL_COLOR_LOGIC_OP),
    NAMED(GL_CULL_FACE),
    NAMED(GL_DEBUG_OUTPUT),
    NAMED(GL_DEBUG_OUTPUT_SYNCHRONOUS),
    NAMED(GL_DEPTH_CLAMP),
    NAMED(GL_DEPTH_TEST),
    NAMED(GL_DITHER),
    NAMED(GL_FRAMEBUFFER_SRGB),
    NAMED(GL_LINE_SMOOTH),
    NAMED(GL_MULTISAMPLE),
    NAMED(GL_POLYGON_OFFSET_FILL),
    NAMED(GL_POLYGON_OFFSET_LINE),
    NAMED(GL_POLYGON_OFFSET_POINT),
    NAMED(GL_POLYGON_SMOOTH),
    NAMED(GL_PRIMITIVE_RESTART),
    NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX),
    NAMED(GL_RASTERIZER_DISCARD),
    NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE),
    NAMED(GL_SAMPLE_ALPHA_TO_ONE),
    NAMED(GL_SAMPLE_COVERAGE),
    NAMED(GL_SAMPLE_SHADING),
    NAMED(GL_SAMPLE_MASK),
    NAMED(GL_SCISSOR_TEST),
    NAMED(GL_STENCIL_TEST),
    NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS),
    NAMED(GL_PROGRAM_POINT_SIZE),
    NAMED(GL_CLIP_DISTANCE0),
    NAMED(GL_CLIP_DISTANCE1),
    NAMED(GL_CLIP_DISTANCE2),
    NAMED(GL_CLIP_DISTANCE3),
    NAMED(GL_CLIP_DISTANCE4),
    NAMED(GL_CLIP_DISTANCE5),
    NAMED(GL_CLIP_DISTANCE6),
    NAMED(GL_CLIP_DISTANCE7),
};

/// Each has up to four values.
constexpr Named numbers[] = {
    NAMED(GL_CURRENT_PROGRAM),
    NAMED(GL_PROGRAM_PIPELINE_BINDING),
    NAMED(GL_VERTEX_ARRAY_BINDING),
    NAMED(GL_ARRAY_BUFFER_BINDING),
    NAMED(GL_ELEMENT_ARRAY_BUFFER_BINDING),
    NAMED(GL_UNIFORM_BUFFER_BINDING),
    NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
    NAMED(GL_ATOMIC_COUNTER_BUFFER_BINDING),
    NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
    NAMED(GL_DRAW_INDIRECT_BUFFER_BINDING),
    NAMED(GL_DISPATCH_INDIRECT_BUFFER_BINDING),
    NAMED(GL_PIXEL_PACK_BUFFER_BINDING),
    NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
    NAMED(GL_TEXTURE_BUFFER_BINDING),
    NAMED(GL_QUERY_BUFFER_BINDING),
    NAMED(GL_COPY_READ_BUFFER_BINDING),
    NAMED(GL_COPY_WRITE_BUFFER_BINDING),
    NAMED(GL_TRANSFORM_FEEDBACK_BINDING),
    NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE),
    NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED),
    NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
    NAMED(GL_READ_FRAMEBUFFER_BINDING),
    NAMED(GL_RENDERBUFFER_BINDING),
    NAMED(GL_ACTIVE_TEXTURE),
    NAMED(GL_BLEND_COLOR),
    NAMED(GL_DEPTH_FUNC),
    NAMED(GL_DEPTH_WRITEMASK),
    NAMED(GL_DEPTH_CLEAR_VALUE),
    NAMED(GL_COLOR_CLEAR_VALUE),
    NAMED(GL_STENCIL_CLEAR_VALUE),
    NAMED(GL_STENCIL_FUNC),
    NAMED(GL_STENCIL_REF),
    NAMED(GL_STENCIL_VALUE_MASK),
    NAMED(GL_STENCIL_WRITEMASK),
    NAMED(GL_STENCIL_FAIL),
    NAMED(GL_STENCIL_PASS_DEPTH_FAIL),
    NAMED(GL_STENCIL_PASS_DEPTH_PASS),
    NAMED(GL_STENCIL_BACK_FUNC),
    NAMED(GL_STENCIL_BACK_REF),
    NAMED(GL_STENCIL_BACK_VALUE_MASK),
    NAMED(GL_STENCIL_BACK_WRITEMASK),
    NAMED(GL_STENCIL_BACK_FAIL),
    NAMED(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
    NAMED(GL_STENCIL_BACK_PASS_DEPTH_PASS),
    NAMED(GL_CULL_FACE_MODE),
    NAMED(GL_FRONT_FACE),
    NAMED(GL_POLYGON_OFFSET_FACTOR),
    NAMED(GL_POLYGON_OFFSET_UNITS),
    NAMED(GL_LOGIC_OP_MODE),
    NAMED(GL_PRIMITIVE_RESTART_INDEX),
    NAMED(GL_LINE_WIDTH),
    NAMED(GL_POINT_SIZE),
    NAMED(GL_POINT_FADE_THRESHOLD_SIZE),
    NAMED(GL_POINT_SPRITE_COORD_ORIGIN),
    NAMED(GL_SAMPLE_COVERAGE_VALUE),
    NAMED(GL_SAMPLE_COVERAGE_INVERT),
    NAMED(GL_MIN_SAMPLE_SHADING_VALUE),
    NAMED(GL_CLIP_ORIGIN),
    NAMED(GL_CLIP_DEPTH_MODE),
    NAMED(GL_PROVOKING_VERTEX),
    NAMED(GL_PATCH_VERTICES),
    NAMED(GL_PATCH_DEFAULT_INNER_LEVEL),
    NAMED(GL_PATCH_DEFAULT_OUTER_LEVEL),
    NAMED(GL_CLAMP_READ_COLOR),
    NAMED(GL_LINE_SMOOTH_HINT),
    NAMED(GL_POLYGON_SMOOTH_HINT),
    NAMED(GL_TEXTURE_COMPRESSION_HINT),
    NAMED(GL_FRAGMENT_SHADER_DERIVATIVE_HINT),
    NAMED(GL_DEBUG_GROUP_STACK_DEPTH),
    NAMED(GL_POLYGON_MODE),
    NAMED(GL_PACK_SWAP_BYTES),
    NAMED(GL_PACK_LSB_FIRST),
    NAMED(GL_PACK_ROW_LENGTH),
    NAMED(GL_PACK_IMAGE_HEIGHT),
    NAMED(GL_PACK_SKIP_ROWS),
    NAMED(GL_PACK_SKIP_PIXELS),
    NAMED(GL_PACK_SKIP_IMAGES),
    NAMED(GL_PACK_ALIGNMENT),
    NAMED(GL_UNPACK_SWAP_BYTES),
    NAMED(GL_UNPACK_LSB_FIRST),
    NAMED(GL_UNPACK_ROW_LENGTH),
    NAMED(GL_UNPACK_IMAGE_HEIGHT),
    NAMED(GL_UNPACK_SKIP_ROWS),
    NAMED(GL_UNPACK_SKIP_PIXELS),
    NAMED(GL_UNPACK_SKIP_IMAGES),
    NAMED(GL_UNPACK_ALIGNMENT),
    NAMED(GL_PACK_COMPRESSED_BLOCK_SIZE),
    NAMED(GL_UNPACK_COMPRESSED_BLOCK_SIZE),
};

/// Only in compatibility contexts.
constexpr Named removed_capabilities[] = {
    NAMED(GL_ALPHA_TEST),     NAMED(GL_AUTO_NORMAL),  NAMED(GL_COLOR_MATERIAL),
    NAMED(GL_COLOR_SUM),      NAMED(GL_FOG),          NAMED(GL_INDEX_LOGIC_OP),
    NAMED(GL_LIGHTING),       NAMED(GL_LINE_STIPPLE), NAMED(GL_NORMALIZE),
    NAMED(GL_POINT_SMOOTH),   NAMED(GL_POINT_SPRITE), NAMED(GL_POLYGON_STIPPLE),
    NAMED(GL_RESCALE_NORMAL), NAMED(GL_TEXTURE_2D),   NAMED(GL_VERTEX_PROGRAM_TWO_SIDE),
};

constexpr Named removed_numbers[] = {
    NAMED(GL_ALPHA_TEST_FUNC),
    NAMED(GL_ALPHA_TEST_REF),
    NAMED(GL_CURRENT_COLOR),
    NAMED(GL_EDGE_FLAG),
    NAMED(GL_CLAMP_FRAGMENT_COLOR),
    NAMED(GL_CLAMP_VERTEX_COLOR),
    NAMED(GL_LINE_STIPPLE_PATTERN),
    NAMED(GL_LINE_STIPPLE_REPEAT),
    NAMED(GL_MATRIX_MODE),
    NAMED(GL_SHADE_MODEL),
    NAMED(GL_FOG_MODE),
    NAMED(GL_FOG_DENSITY),
    NAMED(GL_MAP_COLOR),
    NAMED(GL_INDEX_SHIFT),
    NAMED(GL_INDEX_OFFSET),
    NAMED(GL_RED_SCALE),
    NAMED(GL_RED_BIAS),
    NAMED(GL_GREEN_SCALE),
    NAMED(GL_GREEN_BIAS),
    NAMED(GL_BLUE_SCALE),
    NAMED(GL_BLUE_BIAS),
    NAMED(GL_ALPHA_SCALE),
    NAMED(GL_ALPHA_BIAS),
    NAMED(GL_DEPTH_SCALE),
    NAMED(GL_DEPTH_BIAS),
    NAMED(GL_LIST_INDEX),
    NAMED(GL_RENDER_MODE),
};

/// Per viewport.
constexpr Named of_viewport[] = {NAMED(GL_VIEWPORT), NAMED(GL_SCISSOR_BOX), NAMED(GL_DEPTH_RANGE)};

/// Per draw buffer.
constexpr Named of_draw_buffer[] = {
    NAMED(GL_BLEND_SRC_RGB),   NAMED(GL_BLEND_SRC_ALPHA),    NAMED(GL_BLEND_DST_RGB),
    NAMED(GL_BLEND_DST_ALPHA), NAMED(GL_BLEND_EQUATION_RGB), NAMED(GL_BLEND_EQUATION_ALPHA),
    NAMED(GL_COLOR_WRITEMASK),
};

constexpr Named of_texture_unit[] = {
    NAMED(GL_TEXTURE_BINDING_1D),
    NAMED(GL_TEXTURE_BINDING_1D_ARRAY),
    NAMED(GL_TEXTURE_BINDING_2D),
    NAMED(GL_TEXTURE_BINDING_2D_ARRAY),
    NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE),
    NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY),
    NAMED(GL_TEXTURE_BINDING_3D),
    NAMED(GL_TEXTURE_BINDING_BUFFER),
    NAMED(GL_TEXTURE_BINDING_CUBE_MAP),
    NAMED(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY),
    NAMED(GL_TEXTURE_BINDING_RECTANGLE),
    NAMED(GL_SAMPLER_BINDING),
};

struct IndexedBuffers {
    const char* name;
    GLenum target, binding, start, size;
    int count;
};
constexpr int bindings_looked_at = 8;
constexpr IndexedBuffers indexed_buffers[] = {
    {"uniform", GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START,
     GL_UNIFORM_BUFFER_SIZE, bindings_looked_at},
    {"storage", GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING,
     GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE, bindings_looked_at},
    {"atomic", GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING,
     GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE, 1},
    {"feedback", GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
     GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, 4},
};

constexpr Named of_image_unit[] = {NAMED(GL_IMAGE_BINDING_NAME),    NAMED(GL_IMAGE_BINDING_LEVEL),
                                   NAMED(GL_IMAGE_BINDING_LAYERED), NAMED(GL_IMAGE_BINDING_LAYER),
                                   NAMED(GL_IMAGE_BINDING_ACCESS),  NAMED(GL_IMAGE_BINDING_FORMAT)};

constexpr GLenum queries[] = {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_TIME_ELAPSED,
                              GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN};

using Values = std::array<double, 4>;
std::vector<double> list(const Values& values) {
    return {values.begin(), values.end()};
}

GLint limit(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

class Dump {
  public:
    void add(const std::string& name, std::vector<double> values) {
        values_.push_back({name, std::move(values)});
    }
    void add_indexed(const Named& state, GLuint index) {
        Values values{};
        glGetDoublei_v(state.value, index, values.data());
        add(std::to_string(index) + " " + state.name, list(values));
    }
    void add(std::span<const Named> switches, std::span<const Named> numbers) {
        for (const Named& capability : switches) {
            add(capability.name, {double(glIsEnabled(capability.value))});
        }
        for (const Named& number : numbers) {
            Values values{};
            glGetDoublev(number.value, values.data());
            add(number.name, list(values));
        }
    }
    void add_numbers() {
        add(capabilities, numbers);
        if (gl::is_compatibility()) add(removed_capabilities, removed_numbers);
        GLint mask = 0;
        glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &mask);
        add("GL_SAMPLE_MASK_VALUE", {double(mask)});
    }
    void add_per_index() {
        for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_VIEWPORTS)); ++i) {
            for (const Named& state : of_viewport) add_indexed(state, i);
            add("scissor test " + std::to_string(i), {double(glIsEnabledi(GL_SCISSOR_TEST, i))});
        }
        for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_DRAW_BUFFERS)); ++i) {
            for (const Named& state : of_draw_buffer) add_indexed(state, i);
            add("blend " + std::to_string(i), {double(glIsEnabledi(GL_BLEND, i))});
        }
        for (const IndexedBuffers& buffers : indexed_buffers) {
            for (GLuint i = 0; i < static_cast<GLuint>(buffers.count); ++i) {
                GLint64 values[3]{};
                glGetInteger64i_v(buffers.binding, i, &values[0]);
                glGetInteger64i_v(buffers.start, i, &values[1]);
                glGetInteger64i_v(buffers.size, i, &values[2]);
                add(buffers.name + std::to_string(i),
                    {double(values[0]), double(values[1]), double(values[2])});
            }
        }
        for (GLuint i = 0; i < bindings_looked_at; ++i) {
            for (const Named& state : of_image_unit) add_indexed(state, i);
        }
    }
    void add_textures() {
        const GLint active = limit(GL_ACTIVE_TEXTURE);
        for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS));
             ++i) {
            glActiveTexture(GL_TEXTURE0 + i);
            for (const Named& state : of_texture_unit) {
                add("unit " + std::to_string(i) + " " + state.name, {double(limit(state.value))});
            }
        }
        glActiveTexture(static_cast<GLenum>(active));
    }
    void add_queries() {
        for (const GLenum query : queries) {
            GLint current = 0;
            glGetQueryiv(query, GL_CURRENT_QUERY, &current);
            add("query " + std::to_string(query), {double(current)});
        }
    }
    std::vector<StateValue> take() { return std::move(values_); }

  private:
    std::vector<StateValue> values_;
};

} // namespace

std::vector<StateValue> dump_state() {
    Dump dump;
    dump.add_numbers();
    dump.add_per_index();
    dump.add_textures();
    dump.add_queries();
    return dump.take();
}

std::string differences(const std::vector<StateValue>& before,
                        const std::vector<StateValue>& after) {
    if (before.size() != after.size()) return "of different length";
    const auto text = [](const std::vector<double>& values) {
        std::string result;
        for (const double value : values) result.append(" ").append(std::to_string(value));
        return result;
    };
    std::string result;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == after[i]) continue;
        result += before[i].name + ":" + text(before[i].values) + " became" +
                  text(after[i].values) + "\n";
    }
    return result;
}

OddState::OddState()
    : program_({"paper.vert", "paper.frag"}), vertex_array_(gl::VertexArray::create()),
      sampler_(gl::Sampler::create()), draw_framebuffer_(gl::Framebuffer::create()),
      read_framebuffer_(gl::Framebuffer::create()), renderbuffer_(gl::Renderbuffer::create()) {
    glSamplerParameteri(sampler_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(sampler_.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(sampler_.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    if (gl::is_compatibility()) set_removed();
    program_.use();
    glCreateProgramPipelines(1, &pipeline_);
    glBindProgramPipeline(pipeline_);
    glBindVertexArray(vertex_array_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw_framebuffer_.id());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, read_framebuffer_.id());
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_.id());
    bind_buffers();
    bind_textures();
    set_raster();
    set_pixels();
}

void OddState::set_removed() {
    std::array<GLubyte, 128> every_other{};
    every_other.fill(0x55);
    glPolygonStipple(every_other.data());
    glLineStipple(3, 0x5555);
    glAlphaFunc(GL_GREATER, 0.5F);
    for (const Named& capability : removed_capabilities) glEnable(capability.value);
    glColor4f(1, 0, 0, 0.25F);
    glEdgeFlag(GL_FALSE);
    glShadeModel(GL_FLAT);
    glMatrixMode(GL_PROJECTION);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_DENSITY, 3);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    glPixelTransferi(GL_INDEX_SHIFT, 1);
    glPixelTransferi(GL_INDEX_OFFSET, 2);
    for (const GLenum scale :
         {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE}) {
        glPixelTransferf(scale, 0.5F);
    }
    for (const GLenum bias :
         {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS}) {
        glPixelTransferf(bias, 0.25F);
    }
}

void OddState::bind_buffers() {
    const auto make = [&] {
        gl::Buffer& buffer = buffers_.emplace_back(gl::Buffer::create());
        glNamedBufferStorage(buffer.id(), 4096, nullptr, 0);
        return buffer.id();
    };
    for (const GLenum target :
         {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_DRAW_INDIRECT_BUFFER,
          GL_DISPATCH_INDIRECT_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER,
          GL_TEXTURE_BUFFER, GL_QUERY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER}) {
        glBindBuffer(target, make());
    }
    glCreateTransformFeedbacks(1, &feedback_);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
    for (const IndexedBuffers& buffers : indexed_buffers) {
        for (GLuint i = 0; i < static_cast<GLuint>(buffers.count); ++i) {
            glBindBufferRange(buffers.target, i, make(), 256, 512);
        }
    }
}

void OddState::bind_textures() {
    const std::pair<GLenum, GLenum> kinds[] = {
        {GL_TEXTURE_1D, GL_TEXTURE_1D},
        {GL_TEXTURE_1D_ARRAY, GL_TEXTURE_1D_ARRAY},
        {GL_TEXTURE_2D, GL_TEXTURE_2D},
        {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_2D_ARRAY},
        {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_2D_MULTISAMPLE},
        {GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_2D_MULTISAMPLE_ARRAY},
        {GL_TEXTURE_3D, GL_TEXTURE_3D},
        {GL_TEXTURE_BUFFER, GL_TEXTURE_BUFFER},
        {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP},
        {GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_CUBE_MAP_ARRAY},
        {GL_TEXTURE_RECTANGLE, GL_TEXTURE_RECTANGLE}};
    for (const auto& [target, binding] : kinds) {
        for (GLuint unit = 0; unit < 10; ++unit) {
            GLuint texture = 0;
            glCreateTextures(target, 1, &texture);
            textures_.push_back(texture);
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(binding, texture);
            glBindSampler(unit, sampler_.id());
        }
    }
    for (GLuint unit = 0; unit < bindings_looked_at; ++unit) {
        GLuint texture = 0;
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        textures_.push_back(texture);
        glTextureStorage2D(texture, 1, GL_R32F, 4, 4);
        glBindImageTexture(unit, texture, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    }
    glActiveTexture(GL_TEXTURE7);
}

void OddState::set_raster() {
    const GLenum left_alone[] = {GL_DITHER, GL_MULTISAMPLE, GL_DEBUG_OUTPUT,
                                 GL_DEBUG_OUTPUT_SYNCHRONOUS};
    for (const Named& capability : capabilities) {
        if (std::ranges::find(left_alone, capability.value) == std::end(left_alone)) {
            glEnable(capability.value);
        }
    }
    glDisable(GL_DITHER);
    glDisable(GL_MULTISAMPLE);
    for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_VIEWPORTS)); ++i) {
        const auto shift = static_cast<float>(i);
        glViewportIndexedf(i, 1.5F + shift, 2, 3, 4);
        glScissorIndexed(i, 1, 2 + static_cast<GLint>(i), 3, 4);
        glDepthRangeIndexed(i, 0.75, 0.25);
    }
    for (GLuint i = 0; i < static_cast<GLuint>(limit(GL_MAX_DRAW_BUFFERS)); ++i) {
        glBlendFuncSeparatei(i, GL_DST_COLOR, GL_ONE_MINUS_CONSTANT_COLOR, GL_DST_ALPHA,
                             GL_SRC_ALPHA_SATURATE);
        glBlendEquationSeparatei(i, GL_FUNC_REVERSE_SUBTRACT, GL_MIN);
        glColorMaski(i, GL_FALSE, i % 2 == 0 ? GL_FALSE : GL_TRUE, GL_FALSE, GL_TRUE);
    }
    glBlendColor(0.1F, 0.2F, 0.3F, 0.4F);
    glClearColor(0.4F, 0.3F, 0.2F, 0.1F);
    glClearDepth(0.3);
    glClearStencil(7);
    glDepthFunc(GL_NEVER);
    glDepthMask(GL_FALSE);
    glStencilFuncSeparate(GL_FRONT, GL_NEVER, 3, 0x55);
    glStencilFuncSeparate(GL_BACK, GL_LESS, 4, 0x33);
    glStencilMaskSeparate(GL_FRONT, 0x0F);
    glStencilMaskSeparate(GL_BACK, 0xF0);
    glStencilOpSeparate(GL_FRONT, GL_INVERT, GL_INCR, GL_DECR);
    glStencilOpSeparate(GL_BACK, GL_DECR, GL_INVERT, GL_ZERO);
    glCullFace(GL_FRONT_AND_BACK);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    if (gl::is_compatibility()) glPolygonMode(GL_BACK, GL_POINT);
    glPolygonOffset(3, 5);
    glLogicOp(GL_XOR);
    glPrimitiveRestartIndex(1);
    glLineWidth(1.25F);
    glPointSize(3);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 2);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
    glSampleCoverage(0.5F, GL_TRUE);
    glSampleMaski(0, 2);
    glMinSampleShading(0.5F);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glPatchParameteri(GL_PATCH_VERTICES, 5);
    const float levels[] = {2, 3, 4, 5};
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels);
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels);
    for (const GLenum hint : {GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT,
                              GL_TEXTURE_COMPRESSION_HINT, GL_FRAGMENT_SHADER_DERIVATIVE_HINT}) {
        glHint(hint, GL_NICEST);
    }
}

void OddState::set_pixels() {
    const auto set = [](GLenum name, GLint value) { glPixelStorei(name, value); };
    set(GL_PACK_SWAP_BYTES, GL_TRUE);
    set(GL_PACK_LSB_FIRST, GL_TRUE);
    set(GL_PACK_ROW_LENGTH, 11);
    set(GL_PACK_IMAGE_HEIGHT, 12);
    set(GL_PACK_SKIP_ROWS, 1);
    set(GL_PACK_SKIP_PIXELS, 2);
    set(GL_PACK_SKIP_IMAGES, 3);
    set(GL_PACK_ALIGNMENT, 8);
    set(GL_UNPACK_SWAP_BYTES, GL_TRUE);
    set(GL_UNPACK_LSB_FIRST, GL_TRUE);
    set(GL_UNPACK_ROW_LENGTH, 13);
    set(GL_UNPACK_IMAGE_HEIGHT, 14);
    set(GL_UNPACK_SKIP_ROWS, 3);
    set(GL_UNPACK_SKIP_PIXELS, 1);
    set(GL_UNPACK_SKIP_IMAGES, 2);
    set(GL_UNPACK_ALIGNMENT, 2);
    set(GL_PACK_COMPRESSED_BLOCK_SIZE, 16);
    set(GL_UNPACK_COMPRESSED_BLOCK_SIZE, 16);
}

OddState::~OddState() {
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    glDeleteProgramPipelines(1, &pipeline_);
    glDeleteTransformFeedbacks(1, &feedback_);
}

} // namespace lineatlas::test
