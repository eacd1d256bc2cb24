#include "import_depth_pass.hpp"

#include <string>
#include <utility>

#include "lineatlas/error.hpp"
#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {
namespace {

GLint parameter(GLuint texture, GLenum name) {
    GLint value = 0;
    glGetTextureParameteriv(texture, name, &value);
    return value;
}

GLint level_parameter(GLuint texture, GLenum name) {
    GLint value = 0;
    glGetTextureLevelParameteriv(texture, 0, name, &value);
    return value;
}

/// Whether it is a 2D texture. The test is to bind it as one, because many drivers answer
/// GL_TEXTURE_TARGET only in core contexts.
bool is_2d(GLuint texture) {
    glBindTexture(GL_TEXTURE_2D, texture);
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    return static_cast<GLuint>(bound) == texture;
}

/// Takes the errors of calls that may fail. A lost context may never run out of errors.
void take_errors() {
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

std::string text(glm::ivec2 v) {
    return std::to_string(v.x) + "x" + std::to_string(v.y);
}

[[noreturn]] void refuse(GLuint texture, const std::string& reason) {
    throw UsageError("depth: texture " + std::to_string(texture) + " " + reason);
}

} // namespace

DepthValues check_depth_texture(GLuint texture, glm::ivec2 origin, glm::ivec2 size) {
    if (glIsTexture(texture) == GL_FALSE) refuse(texture, "does not exist in this context");
    if (!is_2d(texture)) {
        const bool multisampled = level_parameter(texture, GL_TEXTURE_SAMPLES) > 0;
        take_errors();
        refuse(texture, multisampled ? "is multisampled; resolve it into a plain one first "
                                       "(glBlitFramebuffer)"
                                     : "is not a 2D texture");
    }
    const GLint bits = level_parameter(texture, GL_TEXTURE_DEPTH_SIZE);
    if (bits == 0) refuse(texture, "has no depth; its format must be one of a depth buffer");
    if (parameter(texture, GL_DEPTH_STENCIL_TEXTURE_MODE) != GL_DEPTH_COMPONENT) {
        refuse(texture,
               "is read as stencil; set GL_DEPTH_STENCIL_TEXTURE_MODE to GL_DEPTH_COMPONENT");
    }
    if (parameter(texture, GL_TEXTURE_BASE_LEVEL) != 0 ||
        parameter(texture, GL_TEXTURE_SWIZZLE_R) != GL_RED) {
        refuse(texture, "has another base level than 0, or a swizzle; reset both");
    }
    const glm::ivec2 whole{level_parameter(texture, GL_TEXTURE_WIDTH),
                           level_parameter(texture, GL_TEXTURE_HEIGHT)};
    const glm::ivec2 end = origin + size;
    if (origin.x < 0 || origin.y < 0 || end.x > whole.x || end.y > whole.y) {
        refuse(texture, "has " + text(whole) + " texels, the viewport takes " + text(size) +
                            " from " + std::to_string(origin.x) + "," + std::to_string(origin.y) +
                            " on (DepthTexture::origin and scale)");
    }
    return {.bits = bits, .floating = level_parameter(texture, GL_TEXTURE_DEPTH_TYPE) == GL_FLOAT};
}

ImportDepthPass::ImportDepthPass()
    : program_({"import_depth.vert", "import_depth.frag"}), vertex_array_(VertexArray::create()),
      sampler_(Sampler::create()), framebuffer_(Framebuffer::create()) {
    glSamplerParameteri(sampler_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(sampler_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void ImportDepthPass::resize(glm::ivec2 size) {
    if (size == size_) return;
    Texture2D texture = Texture2D::create();
    allocate(texture, GL_R32F, size, purpose::depth);
    texture_ = std::move(texture);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, texture_.id(), 0);
    size_ = size;
}

void ImportDepthPass::draw(GLuint depth, glm::ivec2 origin, glm::ivec2 size,
                           const TexelRectangle& part, const DepthMapping& mapping) {
    resize(size);
    if (part.size().x <= 0 || part.size().y <= 0) return;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    set_viewport(part.low, part.size());
    glDisable(GL_DEPTH_TEST);
    glDisablei(GL_BLEND, 0);
    glBindTextureUnit(0, depth);
    glBindSampler(0, sampler_.id());
    program_.use();
    program_.set("depth", 0);
    program_.set("first", origin);
    program_.set("reference", mapping.reference);
    program_.set("scale", mapping.scale);
    glBindVertexArray(vertex_array_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(0, 0);
}

void ImportDepthPass::copy_to(GLuint buffer, const TexelRectangle& part) {
    copy_.copy(texture_.id(), GL_RED, GL_FLOAT, size_, part, buffer);
}

} // namespace lineatlas::gl
