#include "clipped_lines.hpp"

#include <memory>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "compute/cpp/cpp_device.hpp"
#include "compute/stages/stages.hpp"
#include "compute/transfer.hpp"

namespace lineatlas::bench {

using compute::read_back;
using compute::to_device;

ClippedLines clip_lines(const LineSet& lines, const Camera& camera, float step,
                        LineKindMask kinds) {
    const auto device = compute::make_cpp_device();
    compute::Stages stages{*device};
    const auto triangle_count = static_cast<std::uint32_t>(lines.triangles.size());
    const auto count = static_cast<std::uint32_t>(lines.segments.size());
    const std::size_t sums = (std::size_t{count} + 1) * sizeof(std::uint32_t);
    const auto vertices = to_device(*device, lines.vertices);
    const auto triangles = to_device(*device, lines.triangles);
    const auto segments = to_device(*device, lines.segments);
    const auto front = device->allocate(triangle_count);
    const auto clipped = device->allocate(count * sizeof(ClippedSegment));
    const auto offsets = device->allocate(sums);
    const auto arcs = device->allocate(sums);
    const compute::SegmentTable table{*vertices, *triangles, *segments, triangle_count, count};
    const glm::mat4 clip_from_world = camera.clip_from_world();
    stages.facing(table, camera.eye(), *front);
    stages.project_clip({.table = table,
                         .front = *front,
                         .clip_from_world = clip_from_world,
                         .viewport = glm::vec2{camera.size},
                         .step = step,
                         .kind_mask = kinds,
                         .occlusion = nullptr,
                         .out = {*clipped, *offsets, *arcs}});
    stages.scan(*offsets, count, compute::ScanKind::saturate);
    return {read_back<ClippedSegment>(*device, *clipped, count),
            read_back<std::uint32_t>(*device, *offsets, std::size_t{count} + 1)};
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
