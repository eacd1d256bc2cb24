#include "spine_sampler.hpp"

#include <algorithm>
#include <bit>

#include "motion.hpp"

namespace lineatlas::bench {
namespace {

template <class T>
gl::Buffer upload(const std::vector<T>& values) {
    gl::Buffer buffer = gl::Buffer::create();
    glNamedBufferStorage(
        buffer.id(), static_cast<GLsizeiptr>(std::max<std::size_t>(1, values.size()) * sizeof(T)),
        values.empty() ? nullptr : values.data(), 0);
    return buffer;
}

std::uint32_t row_for(const ClippedLines& lines) {
    std::uint32_t longest = 1;
    for (std::size_t i = 0; i < lines.clipped.size(); ++i) {
        longest = std::max(longest, lines.samples(i));
    }
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    return gl::atlas_row(longest, static_cast<std::uint32_t>(largest));
}

} // namespace

SpineSampler::SpineSampler(const LineSet& lines)
    : lines_(lines), connection_(interop::connect({.compute = "cpp"})),
      scene_(*connection_.stages, *connection_.sharing, lines), numbers_(lines.triangles.size()),
      depth_(connection_) {
    depth_.set_scene(scene_);
    connection_.device->download(scene_.surfaces().numbers,
                                 std::as_writable_bytes(std::span{numbers_}));
}

std::vector<ClippedSegment> SpineSampler::numbered(std::vector<ClippedSegment> clipped) const {
    // Packs and numbers own faces as kernels/shared/own_face.h does.
    const auto height = [](std::uint32_t own) { return std::bit_cast<float>(own & 0xFFFF0000U); };
    const auto number = [&](std::uint32_t face, bool is_outside) {
        const std::uint32_t found =
            face != LA_NO_FACE ? numbers_[face & LA_FACE_INDEX] : LA_NO_NUMBER;
        return found | (is_outside ? 0x80000000U : 0U);
    };
    for (std::size_t i = 0; i < clipped.size(); ++i) {
        ClippedSegment& own = clipped[i];
        const float a = height(own.own_a), b = height(own.own_b);
        const bool within = std::max(a, b) > LA_HEIGHT_LIMIT;
        own.own_a = number(lines_.segments[i].face_a, !within && a < 0 && b < 0);
        own.own_b = number(lines_.segments[i].face_b, !within && a > 0 && b > 0);
    }
    return clipped;
}

Renderer::Samples SpineSampler::sample(const ClippedLines& lines, const Camera& camera,
                                       const FrameOptions& options) {
    Frame frame{.camera = camera,
                .options = options,
                .scene = scene_,
                .framebuffer = 0,
                .pens = pens_,
                .backdrop = backdrop_,
                .clock = {*connection_.sharing, false}};
    check_depth_size(camera.size * options.depth_scale);
    depth_.draw_texture(frame);

    const std::uint32_t samples = lines.offsets.back();
    const std::uint32_t row = row_for(lines);
    std::vector<std::uint8_t> texels((samples + row - 1) / row * row);
    const gl::Buffer clipped =
        upload(frame.knows_surfaces() ? numbered(lines.clipped) : lines.clipped);
    const gl::Buffer offsets = upload(lines.offsets);
    const gl::Buffer alpha = upload(texels);
    pass_.program().set("probe_step", options.step);
    pass_.draw(
        {.clipped = clipped.id(), .offsets = offsets.id(), .segment_count = scene_.segment_count()},
        depth_.probed_by_gl(frame), row, samples, alpha.id());
    glGetNamedBufferSubData(alpha.id(), 0, static_cast<GLsizeiptr>(texels.size()), texels.data());

    Renderer::Samples result;
    result.offsets = lines.offsets;
    texels.resize(samples);
    result.alpha = std::move(texels);
    result.runs = spine_runs(lines, result.alpha, camera.size);
    return result;
}

} // namespace lineatlas::bench
