#include "exact_support.hpp"

#include <span>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "compute/stages/exact_visibility.hpp"
#include "compute/transfer.hpp"
#include "core/contact.hpp"

namespace lineatlas::test {
namespace {

using compute::read_back;
using compute::to_device;

} // namespace

ExactResult find_exactly(compute::Device& own, const LineSet& lines, const Camera& camera,
                         LineKindMask kinds) {
    compute::Device* const device = &own;
    compute::Stages stages{own};
    const auto n = static_cast<std::uint32_t>(lines.segments.size());
    const auto triangle_count = static_cast<std::uint32_t>(lines.triangles.size());
    const std::size_t sums = (std::size_t{n} + 1) * sizeof(la_uint);
    const auto vertices = to_device(*device, lines.vertices);
    const auto triangles = to_device(*device, lines.triangles);
    const auto segments = to_device(*device, lines.segments);
    const auto front = device->allocate(triangle_count + 1);
    const auto clipped = device->allocate((n + 1) * sizeof(ClippedSegment));
    const auto arcs = device->allocate(sums);
    const auto zeros = device->allocate(sums);
    device->clear(*zeros, sums);
    const compute::SegmentTable table{*vertices, *triangles, *segments, triangle_count, n};
    const compute::ClippedTable no_samples{*clipped, *zeros, *arcs};

    compute::ExactVisibility exact{stages};
    exact.begin(table, camera, lines.bounds, contact_of(lines));
    stages.facing(table, camera.eye(), *front);
    const glm::mat4 m = camera.clip_from_world();
    stages.project_clip({.table = table,
                         .front = *front,
                         .clip_from_world = m,
                         .viewport = glm::vec2{camera.size},
                         .step = 2,
                         .kind_mask = kinds,
                         .occlusion = nullptr,
                         .out = {*clipped, exact.counts(), *arcs}});
    stages.scan(*arcs, n, compute::ScanKind::wrap);
    exact.surfaces();
    ExactResult result;
    do {
        ++result.looks;
        exact.tile_lists();
        exact.visible(no_samples);
        exact.read_sizes();
    } while (exact.grow(no_samples));

    const compute::SpanTable spans = exact.spans();
    result.clipped = read_back<ClippedSegment>(*device, *clipped, n);
    result.arcs = read_back<std::uint32_t>(*device, *arcs, n + std::size_t{1});
    result.span_offsets = read_back<std::uint32_t>(*device, spans.span_offsets, n + std::size_t{1});
    result.spans =
        read_back<float>(*device, spans.spans, std::size_t{result.span_offsets.back()} * 2);
    // Room for visible parts and the gaps around them.
    const std::uint32_t capacity = 2 * result.span_offsets.back() + n + 1;
    const auto intervals = device->allocate(capacity * sizeof(Interval));
    const auto total = device->allocate(sizeof(la_uint));
    stages.span_intervals({.table = table,
                           .clipped = no_samples,
                           .spans = spans,
                           .viewport = glm::vec2{camera.size},
                           .hidden_too = true,
                           .into = {*intervals, capacity, *total}});
    result.intervals =
        read_back<Interval>(*device, *intervals, read_back<la_uint>(*device, *total, 1)[0]);
    const auto runs = device->allocate(capacity * sizeof(Run));
    const auto record = device->allocate(sizeof(FrameRecord));
    stages.span_runs({.table = table,
                      .clipped = no_samples,
                      .spans = spans,
                      .viewport = glm::vec2{camera.size},
                      .half_width = 1,
                      .hidden = false,
                      .runs = {*runs, *record, capacity}});
    result.runs =
        read_back<Run>(*device, *runs, read_back<FrameRecord>(*device, *record, 1)[0].points[0]);
    return result;
}

float visible_length(const LineSet& lines, const ExactResult& result, glm::vec3 p, glm::vec3 q) {
    float sum = 0;
    for (const Interval& interval : result.intervals) {
        const Segment& segment = lines.segments[interval.segment];
        const glm::vec3 a = lines.vertices[segment.p], b = lines.vertices[segment.q];
        if ((interval.flags & LA_INTERVAL_VISIBLE) == 0) continue;
        if (!(a == p && b == q) && !(a == q && b == p)) continue;
        sum += glm::distance(glm::vec2{interval.start[0], interval.start[1]},
                             glm::vec2{interval.end[0], interval.end[1]});
    }
    return sum;
}

Camera square_camera(int side) {
    Camera camera;
    camera.size = {side, side};
    camera.view = glm::translate(glm::mat4{1}, {0, 0, -1000});
    const auto extent = static_cast<float>(side);
    camera.projection = glm::ortho(0.0F, extent, 0.0F, extent, 1.0F, 2000.0F);
    return camera;
}

Camera square_camera(int side, float distance, float near) {
    Camera camera;
    camera.size = {side, side};
    const float half = 0.5F * static_cast<float>(side);
    camera.view = glm::translate(glm::mat4{1}, {-half, -half, -distance});
    const float reach = half * near / distance;
    camera.projection = glm::frustum(-reach, reach, -reach, reach, near, 10 * distance);
    return camera;
}

} // namespace lineatlas::test
