#include "atlas_pass.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "lineatlas/error.hpp"
#include "segment_table.h"
#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {
namespace {

constexpr GLuint segment_binding = 0;
constexpr GLuint offset_binding = 1;

// Units beyond those that all passes with probes use.
constexpr int number_unit = 6, plane_unit = 7, patch_unit = 8;

constexpr Purpose raster_atlas{"the segment atlas",
                               "use StageForms::atlas compute, a larger FrameOptions::step or a "
                               "smaller Camera::size"};

} // namespace

void ProbeParams::bind(const Program& program, GLuint unit) const {
    const bool known = surfaces.numbers != 0;
    if (!known) glBindTextureUnit(unit, depth);
    program.set("depth", static_cast<int>(unit));
    program.set("viewport", viewport);
    program.set("depth_scale", depth_scale);
    program.set("probes_per_axis", probes);
    program.set("tolerance", tolerance);
    program.set("knows_surfaces", known);
    program.set("parallel_view", surfaces.parallel);
    program.set("bend", surfaces.bend);
    // Samplers of different kinds must never share a unit, even where they are not read.
    program.set("numbers", number_unit);
    program.set("planes", plane_unit);
    program.set("patches", patch_unit);
    if (!known) return;
    glBindTextureUnit(number_unit, surfaces.numbers);
    glBindTextureUnit(plane_unit, surfaces.planes);
    glBindTextureUnit(patch_unit, surfaces.patches);
}

AtlasPass::AtlasPass(std::string_view fragment_shader)
    : program_({"atlas.vert", "atlas.geom", fragment_shader}), vertex_array_(VertexArray::create()),
      framebuffer_(Framebuffer::create()) {
    const GLuint array = vertex_array_.id();
    for (GLuint attribute = 0; attribute < 5; ++attribute) {
        glEnableVertexArrayAttrib(array, attribute);
        glVertexArrayAttribBinding(array, attribute,
                                   attribute < 3 ? segment_binding : offset_binding);
    }
    glVertexArrayAttribFormat(array, 0, 4, GL_FLOAT, GL_FALSE, offsetof(ClippedSegment, p));
    glVertexArrayAttribFormat(array, 1, 4, GL_FLOAT, GL_FALSE, offsetof(ClippedSegment, q));
    glVertexArrayAttribIFormat(array, 2, 2, GL_UNSIGNED_INT, offsetof(ClippedSegment, own_a));
    // The sample count is the next segment's offset less its own.
    glVertexArrayAttribIFormat(array, 3, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribIFormat(array, 4, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t));
}

std::uint32_t atlas_row(std::uint32_t longest, std::uint32_t most) {
    constexpr std::uint32_t usual = 8192;
    if (longest >= most) {
        throw UsageError(beyond_limit(raster_atlas,
                                      "rows of over " + std::to_string(longest) + " samples",
                                      "a row holds " + std::to_string(most) + " here"));
    }
    // A power of two makes eq. 2 cheap.
    const std::uint32_t wanted =
        std::max(usual, longest < (1U << 30U) ? std::bit_ceil(longest + 1) * 2 : most);
    return std::min(wanted, most);
}

void AtlasPass::resize(glm::ivec2 size) {
    if (size_.x == size.x && size_.y >= size.y) return;
    const int largest = largest_side();
    if (size.y > largest) {
        throw DeviceError(beyond_limit(raster_atlas, std::to_string(size.y) + " rows",
                                       "GL draws up to " + std::to_string(largest) + " here"));
    }
    // Room to spare, so that a slowly growing atlas is not made anew in every frame.
    size.y = std::min(size.y + size.y / 2, largest);
    Texture2D texture = Texture2D::create();
    allocate(texture, GL_R8, size, raster_atlas);
    texture_ = std::move(texture);
    glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, texture_.id(), 0);
    size_ = size;
}

void AtlasPass::draw(const ClippedBuffers& segments, const ProbeParams& probes, std::uint32_t row,
                     std::uint32_t samples, GLuint alpha) {
    if (samples == 0) return;
    const auto rows = static_cast<int>((samples - 1) / row + 1);
    resize({static_cast<int>(row), rows});

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    set_viewport({0, 0}, size_);
    glDisable(GL_DEPTH_TEST);
    glDisablei(GL_BLEND, 0);
    glLineWidth(1.0F);
    probes.bind(program_, 0);
    program_.use();
    program_.set("atlas_size", glm::vec2{size_});
    program_.set("capacity", samples);
    glVertexArrayVertexBuffer(vertex_array_.id(), segment_binding, segments.clipped, 0,
                              sizeof(ClippedSegment));
    glVertexArrayVertexBuffer(vertex_array_.id(), offset_binding, segments.offsets, 0,
                              sizeof(std::uint32_t));
    glBindVertexArray(vertex_array_.id());
    for (const bool second : {false, true}) {
        program_.set("second_draw", second);
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(segments.segment_count));
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, alpha);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, rows, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

} // namespace lineatlas::gl
