#include "frame.hpp"

#include <cmath>

#include "core/depth_tolerance.hpp"
#include "glpasses/storage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

std::uint32_t probes_per_axis(std::uint32_t probes) {
    return static_cast<std::uint32_t>(std::lround(std::sqrt(probes)));
}

std::uint32_t Frame::probes_per_axis() const {
    return lineatlas::probes_per_axis(options.probes);
}

float Frame::depth_tolerance() const {
    return lineatlas::depth_tolerance(camera);
}

bool Frame::knows_surfaces() const {
    return !options.own_depth &&
           (options.method == Method::atlas || options.method == Method::spine);
}

bool Frame::culls_hidden() const {
    // With fewer segments, samples and strokes cost less than the pyramid.
    constexpr std::uint32_t fewest_segments = 10'000;
    return options.cull_hidden && options.method != Method::item_buffer &&
           scene.segment_count() >= fewest_segments;
}

gl::StrokeParams Frame::stroke_params(const Pen& pen) const {
    return {.viewport = viewport(),
            .tile = tile,
            .origin = camera.origin,
            .width = pen.width,
            .color = glm::vec4{pen.color, pen.opacity},
            .pen = pens.get(pen.mark, pen.width)};
}

gl::ProbeParams Frame::probe_params(GLuint depth) const {
    return {.depth = depth,
            .viewport = viewport(),
            .depth_scale = static_cast<float>(depth_scale()),
            .probes = probes_per_axis(),
            .tolerance = depth_tolerance()};
}

bool has_depth_attachment(GLuint framebuffer) {
    GLint type = GL_NONE;
    glGetNamedFramebufferAttachmentParameteriv(framebuffer,
                                               framebuffer != 0 ? GL_DEPTH_ATTACHMENT : GL_DEPTH,
                                               GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    return type != GL_NONE;
}

void check_depth_size(glm::ivec2 size) {
    gl::check_side(size, purpose::depth);
}

bool has_bytes(GLuint framebuffer) {
    GLint buffer = GL_BACK_LEFT, type = GL_NONE, bits = 0;
    if (framebuffer != 0) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glGetIntegerv(GL_DRAW_BUFFER, &buffer);
        if (buffer == GL_NONE) return false;
    }
    const auto attachment = static_cast<GLenum>(buffer);
    glGetNamedFramebufferAttachmentParameteriv(framebuffer, attachment,
                                               GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_NONE) return false;
    glGetNamedFramebufferAttachmentParameteriv(framebuffer, attachment,
                                               GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &bits);
    return bits <= 8;
}

} // namespace lineatlas
