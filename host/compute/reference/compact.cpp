#include "stages.hpp"

#include <algorithm>
#include <cmath>

namespace lineatlas::compute::reference {
namespace {

glm::vec2 window_position(const float (&clip)[4], glm::vec2 viewport) {
    return (glm::vec2{clip[0], clip[1]} / clip[3] + 1.0F) * (viewport * 0.5F);
}

glm::vec2 window_direction(const ClippedSegment& segment, glm::vec2 viewport) {
    const glm::vec2 d = window_position(segment.q, viewport) - window_position(segment.p, viewport);
    const float length_px = std::sqrt(d.x * d.x + d.y * d.y);
    return length_px > 0 ? d / length_px : glm::vec2{0};
}

glm::vec2 left_of(glm::vec2 direction) {
    return {-direction.y, direction.x};
}

struct End {
    std::uint32_t style;
    glm::vec2 mitre; ///< from the spine to the left corner, for half-width 1
};

/// §4.5, mitering: see `join` in compact.cl.
End join(glm::vec2 own, glm::vec2 other, float room, float half_width) {
    const float cosine = own.x * other.x + own.y * other.y;
    if (cosine < LA_MITRE_LIMIT_COSINE) return {LA_END_ROUND, left_of(own)};
    const glm::vec2 corner = (left_of(own) + left_of(other)) / (1.0F + cosine);
    const float along = corner.x * own.x + corner.y * own.y;
    if (std::fabs(along) * half_width > room) return {LA_END_ROUND, left_of(own)};
    return {LA_END_MITRE, corner};
}

End segment_end(const CompactRunsInput& in, std::uint32_t i, bool at_end, glm::vec2 direction) {
    const Segment& segment = in.segments[i];
    const bool clipped = at_end ? in.clipped[i].t1 < 1 : in.clipped[i].t0 > 0;
    if (clipped) return {LA_END_BUTT, left_of(direction)};
    const bool last = at_end ? segment.to_end == 0 : segment.from_start == 0;
    if (last && (segment.tag & LA_TAG_CLOSED) == 0) return {LA_END_ROUND, left_of(direction)};
    std::uint32_t neighbour = at_end ? i + 1 : i - 1;
    if (last) neighbour = at_end ? i - segment.from_start : i + segment.to_end;
    // Arc lengths, not sample counts: a neighbour that is hidden whole has no samples.
    const std::uint32_t neighbour_length = in.arcs[neighbour + 1] - in.arcs[neighbour];
    if (neighbour_length == 0) return {LA_END_ROUND, left_of(direction)};
    const std::uint32_t own_length = in.arcs[i + 1] - in.arcs[i];
    const float room = static_cast<float>(std::min(own_length, neighbour_length)) *
                       (1.0F / LA_ARC_UNITS_PER_PIXEL);
    return join(direction, window_direction(in.clipped[neighbour], in.viewport), room,
                in.half_width);
}

/// The run of samples [a, end) of segment i.
Run make_run(const CompactRunsInput& in, std::uint32_t i, std::uint32_t a, std::uint32_t end) {
    const Segment& segment = in.segments[i];
    const std::uint32_t l = in.offsets[i + 1] - in.offsets[i];
    const float start_sample = a == 0 ? 0.0F : static_cast<float>(a) - 0.5F;
    const float end_sample = end == l ? static_cast<float>(l) : static_cast<float>(end) + 0.5F;
    const glm::vec2 p = window_position(in.clipped[i].p, in.viewport);
    const glm::vec2 d = window_position(in.clipped[i].q, in.viewport) - p;
    const glm::vec2 direction = window_direction(in.clipped[i], in.viewport);
    const End butt{LA_END_BUTT, left_of(direction)};
    const End start = a == 0 ? segment_end(in, i, false, direction) : butt;
    const End finish = end == l ? segment_end(in, i, true, direction) : butt;

    const std::uint32_t path_first = i - segment.from_start;
    const std::uint32_t path_last = i + segment.to_end;
    const auto pixels = [](std::uint32_t arc) {
        return static_cast<float>(arc) * (1.0F / LA_ARC_UNITS_PER_PIXEL);
    };
    const float half_path = pixels(in.arcs[path_last + 1] - in.arcs[path_first]) * 0.5F;
    const float arc = pixels(in.arcs[i] - in.arcs[path_first]) - half_path;
    const float length_px = pixels(in.arcs[i + 1] - in.arcs[i]);
    const float u0 = start_sample / static_cast<float>(l);
    const float u1 = end_sample / static_cast<float>(l);
    const glm::vec2 start_px = p + d * u0;
    const glm::vec2 end_px = p + d * u1;
    return {.start = {start_px.x, start_px.y},
            .end = {end_px.x, end_px.y},
            .start_mitre = {start.mitre.x, start.mitre.y},
            .end_mitre = {finish.mitre.x, finish.mitre.y},
            .start_arc = arc + length_px * u0,
            .end_arc = arc + length_px * u1,
            .start_sample = start_sample,
            .end_sample = end_sample,
            .address = in.layout.address(in.offsets[i]),
            .samples = l,
            .flags = start.style << LA_RUN_START_SHIFT | finish.style << LA_RUN_END_SHIFT |
                     (segment.tag & LA_TAG_KIND_MASK) << LA_RUN_KIND_SHIFT,
            .segment = i};
}

} // namespace

void compact_runs(const CompactRunsInput& in, std::span<Run> runs, FrameRecord& record) {
    std::uint32_t total = 0;
    for (std::uint32_t i = 0; i < in.segments.size(); ++i) {
        const std::uint32_t s = in.offsets[i];
        const std::uint32_t l = in.offsets[i + 1] - s;
        if (l == 0 || l > in.capacity || s > in.capacity - l) continue;
        const std::span own = in.alpha.subspan(in.layout.address(s), l);
        for (auto a = own.begin(); a != own.end();) {
            a = std::find_if(a, own.end(), [](std::uint8_t alpha) { return alpha != 0; });
            if (a == own.end()) break;
            const auto end = std::find(a, own.end(), std::uint8_t{0});
            if (total < runs.size()) {
                runs[total] = make_run(in, i, static_cast<std::uint32_t>(a - own.begin()),
                                       static_cast<std::uint32_t>(end - own.begin()));
            }
            ++total;
            a = end;
        }
    }
    const std::uint32_t drawn = total <= runs.size() ? total : 0;
    record = {.points = {drawn, 1, 0, 0},
              .quads = {4, drawn, 0, 0},
              .sample_total = in.offsets[in.segments.size()],
              .run_total = total,
              .unused = {0, 0}};
}

std::uint32_t compact_samples(std::span<const std::uint8_t> alpha,
                              std::span<std::uint32_t> packed) {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < alpha.size(); ++i) {
        if (alpha[i] != 0) packed[count++] = i;
    }
    return count;
}

} // namespace lineatlas::compute::reference
