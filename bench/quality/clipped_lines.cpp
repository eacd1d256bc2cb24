#include "clipped_lines.hpp"

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "compute/reference/stages.hpp"

namespace lineatlas::bench {

namespace reference = compute::reference;

ClippedLines clip_lines(const LineSet& lines, const Camera& camera, float step,
                        LineKindMask kinds) {
    const auto floats =
        std::span{reinterpret_cast<const float*>(lines.vertices.data()), lines.vertices.size() * 3};
    const auto indices = std::span{reinterpret_cast<const std::uint32_t*>(lines.triangles.data()),
                                   lines.triangles.size() * 3};
    std::vector<std::uint8_t> front(lines.triangles.size());
    reference::facing(floats, indices, camera.eye(), front);
    ClippedLines result;
    result.clipped.resize(lines.segments.size());
    result.offsets.resize(lines.segments.size() + 1);
    std::vector<std::uint32_t> arcs(lines.segments.size() + 1);
    const glm::mat4 clip_from_world = camera.clip_from_world();
    reference::project_clip(
        {.segments = lines.segments,
         .vertices = floats,
         .triangles = indices,
         .front = front,
         .clip_from_world = clip_from_world,
         .world_from_clip = glm::mat4{glm::inverse(glm::dmat4{clip_from_world})},
         .viewport = glm::vec2{camera.size},
         .step = step,
         .kind_mask = kinds},
        result.clipped, result.offsets, arcs);
    reference::scan(result.offsets, compute::ScanKind::saturate);
    return result;
}

WindowSegment window_segment(const ClippedSegment& segment, glm::ivec2 viewport) {
    const auto place = [&](const float* clip) {
        return (glm::dvec2{clip[0], clip[1]} / double{clip[3]} + 1.0) * glm::dvec2{viewport} * 0.5;
    };
    return {place(segment.p), place(segment.q)};
}

double parameter_at(const ClippedSegment& segment, double u) {
    const double wp = segment.p[3], wq = segment.q[3];
    const double v = u * wp / (u * wp + (1 - u) * wq);
    return segment.t0 + (double{segment.t1} - segment.t0) * v;
}

std::optional<double> share_at(const ClippedSegment& segment, double t) {
    const double v = (t - segment.t0) / (double{segment.t1} - segment.t0);
    if (!(v >= 0 && v <= 1)) return std::nullopt;
    const double wp = segment.p[3], wq = segment.q[3];
    return v * wq / (v * wq + (1 - v) * wp);
}

} // namespace lineatlas::bench
