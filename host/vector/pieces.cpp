#include "pieces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace lineatlas {
namespace {

struct ClipPoint {
    glm::dvec3 world;
    glm::dvec4 clip;
};

/// How far in front of the near plane, in clip space.
double before_near(const ClipPoint& point) {
    return point.clip.z + point.clip.w;
}

ClipPoint mix(const ClipPoint& a, const ClipPoint& b, double share) {
    return {.world = a.world + (b.world - a.world) * share,
            .clip = a.clip + (b.clip - a.clip) * share};
}

class Projector {
  public:
    explicit Projector(const Camera& camera)
        : clip_from_world_(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          size_(camera.size) {}

    std::optional<ScreenSegment> project(glm::vec3 p, glm::vec3 q) const {
        ClipPoint a = clip(p);
        ClipPoint b = clip(q);
        const double near_a = before_near(a);
        const double near_b = before_near(b);
        if (near_a < 0 && near_b < 0) return {};
        const double crossing = near_a / (near_a - near_b);
        if (near_a < 0) {
            a = mix(a, b, crossing);
        } else if (near_b < 0) {
            b = mix(a, b, crossing);
        }
        if (!(a.clip.w > 0) || !(b.clip.w > 0)) return {};
        ScreenSegment segment{.p = on_screen(a), .q = on_screen(b)};
        segment.length = glm::distance(segment.p.at, segment.q.at);
        return segment;
    }

  private:
    ClipPoint clip(glm::vec3 world) const {
        return {.world = world, .clip = clip_from_world_ * glm::dvec4{glm::dvec3{world}, 1}};
    }

    VectorPoint on_screen(const ClipPoint& point) const {
        const glm::dvec3 device = glm::dvec3{point.clip} / point.clip.w;
        return {.at = {(device.x + 1) * 0.5 * size_.x, (1 - device.y) * 0.5 * size_.y},
                .depth = (device.z + 1) * 0.5,
                .inverse_w = 1 / point.clip.w,
                .world = point.world};
    }

    glm::dmat4 clip_from_world_;
    glm::dvec2 size_;
};

bool is_finite(const Interval& interval) {
    return std::isfinite(interval.start[0]) && std::isfinite(interval.start[1]) &&
           std::isfinite(interval.end[0]) && std::isfinite(interval.end[1]) &&
           std::isfinite(interval.start_arc) && std::isfinite(interval.end_arc);
}

/// A name of an end. Ends that meet have the same name, bit by bit.
std::uint64_t name_of_end(const float* window) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(window[0])} << 32U |
           std::bit_cast<std::uint32_t>(window[1]);
}

/// Whether only the intervals of a segment tell where it runs. That is so for contours, whose
/// vertices are those of the frame, and for centre lines, which hang over their ends.
bool goes_as_far_as_found(const LineSet& lines, std::uint32_t segment) {
    return is_contour(lines, segment) ||
           (lines.segments[segment].tag & LA_TAG_KIND_MASK) == LA_KIND_CENTRE;
}

/// A contour as a segment, as far as its intervals go.
std::optional<ScreenSegment> contour_segment(const Projector& projector, const Interval& first,
                                             const Interval& last) {
    const auto point = [](const float* at) { return glm::vec3{at[0], at[1], at[2]}; };
    std::optional<ScreenSegment> screen =
        projector.project(point(first.start_world), point(last.end_world));
    if (!screen) return {};
    screen->end_p = name_of_end(first.start);
    screen->end_q = name_of_end(last.end);
    return screen;
}

/// Whether interval `next` is of the same straight line as the intervals from `first` to `last`. A
/// silhouette on a known surface has several lines in place of one segment, each from its own start
/// on.
bool is_of_same_line(const Interval& first, const Interval& last, const Interval& next) {
    if (next.segment != last.segment || next.start_sample < last.end_sample) return false;
    const auto place = [](const float* window) { return glm::dvec2{window[0], window[1]}; };
    const glm::dvec2 way = place(next.end) - place(first.start);
    const auto is_beside = [&](const float* window) {
        const glm::dvec2 to = place(window) - place(first.start);
        return std::abs(way.x * to.y - way.y * to.x) <= same_place * glm::length(way);
    };
    return is_beside(last.end) && is_beside(next.start);
}

/// Where along a segment a window position (y up) lies.
double share_along(const ScreenSegment& segment, const float* window, double height) {
    if (!(segment.length > 0)) return 0;
    const glm::dvec2 way = segment.q.at - segment.p.at;
    const glm::dvec2 offset = glm::dvec2{window[0], height - double{window[1]}} - segment.p.at;
    return std::clamp(glm::dot(offset, way) / glm::dot(way, way), 0.0, 1.0);
}

PieceEnd make_end(const ScreenSegment& segment, const float* window, double height,
                  std::uint32_t kind, double vertex) {
    // The end is exactly at the vertex, so that neighbours meet bit by bit.
    const bool at_it = at_vertex(kind);
    return {.t = at_it ? vertex : share_along(segment, window, height), .kind = kind};
}

} // namespace

VectorPoint between(const VectorPoint& a, const VectorPoint& b, double share) {
    if (share == 0) return a;
    if (share == 1) return b;
    VectorPoint point{.at = a.at + (b.at - a.at) * share,
                      .depth = std::lerp(a.depth, b.depth, share),
                      .inverse_w = std::lerp(a.inverse_w, b.inverse_w, share),
                      .arc = std::lerp(a.arc, b.arc, share)};
    // Positions over w are linear on the screen. Beyond the horizon there is no point to name.
    const glm::dvec3 over_w =
        a.world * a.inverse_w + (b.world * b.inverse_w - a.world * a.inverse_w) * share;
    point.world = point.inverse_w > 0 ? over_w / point.inverse_w : (share < 0.5 ? a : b).world;
    return point;
}

bool at_vertex(std::uint32_t kind) {
    return kind == LA_END_PATH || kind == LA_END_JOIN || kind == LA_END_ROUND;
}

bool is_contour(const LineSet& lines, std::uint32_t segment) {
    return segment >= lines.segments.size() - lines.contours.faces.size();
}

bool share_vertex(const Segment& a, const Segment& b) {
    return a.p == b.p || a.p == b.q || a.q == b.p || a.q == b.q;
}

void drop_flickers(Pieces& pieces) {
    constexpr double shortest = 0.01; // pixels
    std::erase_if(pieces.list, [&](const Piece& piece) {
        return (piece.start.t > 0 || piece.end.t < 1) && pieces.length(piece) < shortest;
    });
}

bool goes_on(const LineSet& lines, const Pieces& pieces, const Piece& a, const Piece& b) {
    return lines.segments[a.segment].path == lines.segments[b.segment].path &&
           glm::distance(pieces.end(a).at, pieces.start(b).at) < same_place;
}

Pieces make_pieces(const LineSet& lines, const Camera& camera,
                   std::span<const Interval> intervals) {
    const Projector projector{camera};
    const double height = camera.size.y;
    Pieces pieces;
    pieces.list.reserve(intervals.size());
    pieces.exact = std::ranges::all_of(intervals, [](const Interval& interval) {
        return (interval.flags & LA_INTERVAL_EXACT) != 0;
    });
    bool is_seen = false;
    std::size_t next_line = 0; // the first interval behind those of the last segment's line
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const Interval& interval = intervals[i];
        if (interval.segment >= lines.segments.size() || !is_finite(interval)) continue;
        if (i >= next_line) {
            std::size_t last = i;
            while (last + 1 < intervals.size() &&
                   is_of_same_line(interval, intervals[last], intervals[last + 1]))
                ++last;
            next_line = last + 1;
            const Segment& segment = lines.segments[interval.segment];
            const std::optional<ScreenSegment> screen =
                goes_as_far_as_found(lines, interval.segment)
                    ? contour_segment(projector, interval, intervals[last])
                    : projector.project(lines.vertices[segment.p], lines.vertices[segment.q]);
            is_seen = screen.has_value();
            if (is_seen) pieces.screen.push_back(*screen);
        }
        if (!is_seen) continue;
        ScreenSegment& screen = pieces.screen.back();
        Piece piece{.segment = interval.segment,
                    .screen = static_cast<std::uint32_t>(pieces.screen.size() - 1),
                    .visible = (interval.flags & LA_INTERVAL_VISIBLE) != 0,
                    .alpha = interval.alpha};
        piece.start = make_end(screen, interval.start, height,
                               interval.flags >> LA_INTERVAL_START_SHIFT & LA_END_MASK, 0);
        piece.end = make_end(screen, interval.end, height,
                             interval.flags >> LA_INTERVAL_END_SHIFT & LA_END_MASK, 1);
        piece.end.t = std::max(piece.end.t, piece.start.t);
        screen.p.arc = double{interval.start_arc} - piece.start.t * screen.length;
        screen.q.arc = screen.p.arc + screen.length;
        pieces.list.push_back(piece);
    }
    return pieces;
}

} // namespace lineatlas
