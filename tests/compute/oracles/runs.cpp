#include "runs.hpp"

#include <algorithm>
#include <cmath>

namespace lineatlas::test::oracles {
namespace {

glm::vec2 window_position(const float (&clip)[4], glm::vec2 viewport) {
    return (glm::vec2{clip[0], clip[1]} / clip[3] + 1.0F) * (viewport * 0.5F);
}

float window_depth(const float (&clip)[4]) {
    return (clip[2] / clip[3] + 1.0F) * 0.5F;
}

glm::vec2 window_direction(const ClippedSegment& segment, glm::vec2 viewport) {
    const glm::vec2 d = window_position(segment.q, viewport) - window_position(segment.p, viewport);
    const float length_px = std::sqrt(d.x * d.x + d.y * d.y);
    return length_px > 0 ? d / length_px : glm::vec2{0};
}

float pixels(std::uint32_t arc) {
    return static_cast<float>(arc) * (1.0F / LA_ARC_UNITS_PER_PIXEL);
}

End join(glm::vec2 own, glm::vec2 other, float room, float half_width) {
    const float cosine = own.x * other.x + own.y * other.y;
    if (cosine < LA_JOIN_LIMIT_COSINE) return {LA_END_ROUND};
    const glm::vec2 sum = own + other;
    const glm::vec2 left = glm::vec2{-sum.y, sum.x} * (2 / (sum.x * sum.x + sum.y * sum.y));
    const float along = left.x * own.x + left.y * own.y;
    if (std::fabs(along) * half_width > room) return {LA_END_ROUND}; // corners would cross
    return {LA_END_JOIN, left};
}

} // namespace

float FrameTables::arc(std::uint32_t i) const {
    const std::uint32_t first = i - segments[i].from_start;
    const std::uint32_t last = i + segments[i].to_end;
    const float half_path = pixels(arcs[last + 1] - arcs[first]) * 0.5F;
    return pixels(arcs[i] - arcs[first]) - half_path;
}

float FrameTables::length(std::uint32_t i) const {
    return pixels(arcs[i + 1] - arcs[i]);
}

bool FrameTables::goes_on(std::uint32_t i) const {
    return segments[i].to_end > 0 && clipped[i].t1 >= 1 && is_drawn(i + 1) &&
           clipped[i + 1].t0 <= 0;
}

std::uint32_t path_end(const FrameTables& frame, std::uint32_t i, bool at_end,
                       std::uint32_t& neighbour) {
    const Segment& segment = frame.segments[i];
    const bool clipped = at_end ? frame.clipped[i].t1 < 1 : frame.clipped[i].t0 > 0;
    if (clipped) return LA_END_CLIPPED;
    const bool last = at_end ? segment.to_end == 0 : segment.from_start == 0;
    if (last && (segment.tag & LA_TAG_CLOSED) == 0) return LA_END_PATH;
    neighbour = at_end ? i + 1 : i - 1;
    if (last) neighbour = at_end ? i - segment.from_start : i + segment.to_end;
    // By arc lengths, not by samples, because an entirely hidden neighbour has no samples.
    return frame.is_drawn(neighbour) ? LA_END_JOIN : LA_END_CLIPPED;
}

End segment_end(const FrameTables& frame, std::uint32_t i, bool at_end) {
    std::uint32_t neighbour = i;
    const std::uint32_t kind = path_end(frame, i, at_end, neighbour);
    if (kind != LA_END_JOIN) return {kind};
    const std::uint32_t shorter = std::min(frame.arcs[i + 1] - frame.arcs[i],
                                           frame.arcs[neighbour + 1] - frame.arcs[neighbour]);
    return join(window_direction(frame.clipped[i], frame.viewport),
                window_direction(frame.clipped[neighbour], frame.viewport), pixels(shorter),
                frame.half_width);
}

Place place_at(const FrameTables& frame, std::uint32_t i, float sample, std::uint32_t l) {
    const ClippedSegment& clipped = frame.clipped[i];
    const glm::vec2 p = window_position(clipped.p, frame.viewport);
    const glm::vec2 q = window_position(clipped.q, frame.viewport);
    const float depth_p = window_depth(clipped.p);
    const float depth_q = window_depth(clipped.q);
    const float u = sample / static_cast<float>(l);
    return {.position = u == 1 ? q : p + (q - p) * u, // exactly the start of the next segment
            .depth = depth_p + (depth_q - depth_p) * u,
            .arc = frame.arc(i) + frame.length(i) * u};
}

Run make_run(const FrameTables& frame, std::uint32_t i, float start_sample, float end_sample,
             std::uint32_t l, const End& start, const End& end) {
    const Place from = place_at(frame, i, start_sample, l);
    const Place to = place_at(frame, i, end_sample, l);
    Run run{};
    run.start[0] = from.position.x;
    run.start[1] = from.position.y;
    run.end[0] = to.position.x;
    run.end[1] = to.position.y;
    run.start_corner[0] = start.corner.x;
    run.start_corner[1] = start.corner.y;
    run.end_corner[0] = end.corner.x;
    run.end_corner[1] = end.corner.y;
    run.start_arc = run.stroke_start = from.arc;
    run.end_arc = run.stroke_end = to.arc;
    run.start_sample = start_sample;
    run.end_sample = end_sample;
    run.start_depth = from.depth;
    run.end_depth = to.depth;
    run.samples = l;
    run.segment = i;
    run.flags = start.kind << LA_RUN_START_SHIFT | end.kind << LA_RUN_END_SHIFT |
                start.kind << LA_STROKE_START_SHIFT | end.kind << LA_STROKE_END_SHIFT;
    return run;
}

bool shown_across(std::span<const Segment> segments, std::span<const Run> runs, std::size_t r,
                  bool at_end) {
    const std::uint32_t kind =
        runs[r].flags >> (at_end ? LA_RUN_END_SHIFT : LA_RUN_START_SHIFT) & LA_END_MASK;
    if (kind == LA_END_HIDDEN) return false;
    if (kind != LA_END_JOIN && kind != LA_END_ROUND) return true;
    const std::uint32_t segment = runs[r].segment;
    const std::uint32_t before = segments[segment].from_start, after = segments[segment].to_end;
    std::size_t other = r;
    if (at_end) {
        const std::uint32_t next = after > 0 ? segment + 1 : segment - before;
        if (after > 0) {
            ++other;
        } else {
            while (other > 0 && runs[other - 1].segment >= next) --other;
        }
        return other < runs.size() && runs[other].segment == next && runs[other].start_sample == 0;
    }
    const std::uint32_t previous = before > 0 ? segment - 1 : segment + after;
    if (before > 0) {
        if (r == 0) return false;
        --other;
    } else {
        while (other + 1 < runs.size() && runs[other + 1].segment <= previous) ++other;
    }
    return runs[other].segment == previous &&
           runs[other].end_sample == static_cast<float>(runs[other].samples);
}

FrameRecord make_record(std::size_t runs, std::size_t capacity, std::uint32_t samples) {
    const auto total = static_cast<std::uint32_t>(runs);
    const std::uint32_t drawn = runs <= capacity ? total : 0;
    return {.points = {drawn, 1, 0, 0},
            .sample_total = samples,
            .run_total = total,
            .raw_run_total = total,
            .unused = 0};
}

} // namespace lineatlas::test::oracles
