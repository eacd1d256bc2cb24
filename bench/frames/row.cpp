#include "row.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "core/median.hpp"

namespace lineatlas::bench {
namespace {

template <class T>
gl::Buffer upload(const std::vector<T>& values) {
    gl::Buffer buffer = gl::Buffer::create();
    const std::size_t count = std::max<std::size_t>(1, values.size());
    glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(count * sizeof(T)),
                         values.empty() ? nullptr : values.data(), 0);
    return buffer;
}

double median_of_stages(std::span<const FrameProfile> profiles) {
    std::vector<double> sums;
    for (const FrameProfile& profile : profiles) {
        double sum = 0;
        for (const StageShare& share : stage_shares(profile)) sum += share.nanoseconds;
        sums.push_back(sum * 1e-6);
    }
    return median(std::move(sums));
}

} // namespace

DepthOnly::DepthOnly(const LineSet& lines)
    : vertices_(upload(lines.vertices)), indices_(upload(lines.triangles)),
      triangle_count_(static_cast<std::uint32_t>(lines.triangles.size())) {}

Contestant DepthOnly::contestant(int scale) {
    gl::DepthPass& pass = passes_[scale - 1];
    return {
        fmt::format("{}x", scale),
        [this, &pass, scale](const Camera& camera, bool) {
            pass.begin(camera.size, scale);
            pass.draw({vertices_.id(), indices_.id(), triangle_count_}, camera.clip_from_world());
            return FrameStats{};
        },
        false};
}

FrameOptions method_options(const MethodSpec& spec) {
    FrameOptions options;
    options.method = spec.method;
    options.probes = spec.probes;
    options.depth_scale = spec.depth_scale;
    if (spec.reads_back) options.intervals = KeptIntervals::visible;
    return options;
}

Row::Row(const Subject& subject, std::span<const Drawn> drawings, const DeviceOptions& device,
         gl::Canvas& canvas)
    : depth_(subject.lines) {
    result_.name = subject.name;
    result_.triangles = static_cast<std::uint32_t>(subject.lines.triangles.size());
    result_.segments = static_cast<std::uint32_t>(subject.lines.segments.size());
    for (const Drawn& drawn : drawings) {
        Renderer& renderer = *renderers_.emplace_back(std::make_unique<Renderer>(device));
        renderer.set_lines(subject.lines);
        description_ = renderer.description();
        FrameOptions options = drawn.options;
        options.lines = subject.kinds;
        const bool profiled = options.profile;
        const auto draw = [this, &renderer, &canvas, options, profiled, animate = subject.animate,
                           frame = std::size_t{0}](const Camera& camera, bool stages) mutable {
            options.measure_stages = stages;
            options.profile = profiled && !stages;
            canvas.clear(glm::vec4{1});
            if (animate) animate(renderer, frame++);
            const FrameStats stats = renderer.draw(camera, options, canvas.framebuffer());
            if (options.intervals != KeptIntervals::none) renderer.read_intervals();
            if (options.profile)
                std::ranges::move(renderer.take_profiles(false), std::back_inserter(profiles_));
            return stats;
        };
        contestants_.push_back({drawn.name, draw});
    }
    for (const int scale : {1, 2}) contestants_.push_back(depth_.contestant(scale));
}

SceneResult Row::result(std::span<const Measured> measured) const {
    SceneResult result = result_;
    const auto methods = measured.first(renderers_.size());
    const auto depth = measured.subspan(renderers_.size());
    result.methods.assign(methods.begin(), methods.end());
    result.depth.assign(depth.begin(), depth.end());
    result.profiled_ms = median_of_stages(profiles_);
    return result;
}

} // namespace lineatlas::bench
