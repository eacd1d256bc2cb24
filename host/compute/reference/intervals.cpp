#include <algorithm>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "probe.hpp"
#include "runs.hpp"
#include "stages.hpp"

namespace lineatlas::compute::reference {
namespace {

constexpr std::uint32_t probes = 9;

/// A segment along which a change of visibility is looked for.
struct Line {
    Spine spine;
    std::uint32_t l;     ///< samples
    float pixel;         ///< length of a pixel in samples
    std::uint32_t least; ///< visibility (of 255) from which on it counts as visible
};

/// A part of a segment: from one change of visibility to the next, counted in samples.
struct Piece {
    float start, end;
    std::uint32_t start_change, end_change;
    bool visible;
};

class Finder {
  public:
    explicit Finder(const IntervalsInput& in)
        : in_(in), frame_{.segments = in.segments,
                          .clipped = in.clipped,
                          .offsets = in.offsets,
                          .arcs = in.arcs,
                          .viewport = in.viewport,
                          .half_width = 0},
          depth_{in.depth, in.depth_size, in.depth_scale, in.tolerance} {}

    std::vector<Interval> find() {
        for (std::uint32_t i = 0; i < in_.segments.size(); ++i) {
            if (frame_.is_drawn(i)) find_in(i);
        }
        return std::move(found_);
    }

    /// Puts both ends where they belong.
    void refine(Interval& interval) const {
        const std::uint32_t i = interval.segment;
        const std::uint32_t l = std::max(frame_.samples(i), 1U);
        const Line line{make_spine(in_.clipped[i], in_.viewport, in_.depth_scale), l,
                        static_cast<float>(l) / frame_.length(i), least_shown(i)};
        const bool visible = (interval.flags & LA_INTERVAL_VISIBLE) != 0;
        const auto change = [&](std::uint32_t shift) {
            return interval.flags >> shift & LA_CHANGE_MASK;
        };
        interval.start_sample =
            narrow(line, change(LA_INTERVAL_START_CHANGE_SHIFT), interval.start_sample, !visible);
        interval.end_sample =
            narrow(line, change(LA_INTERVAL_END_CHANGE_SHIFT), interval.end_sample, visible);
        const Place start = place_at(frame_, i, interval.start_sample, l);
        const Place end = place_at(frame_, i, interval.end_sample, l);
        const glm::vec3 start_world = world_point(i, interval.start_sample / static_cast<float>(l));
        const glm::vec3 end_world = world_point(i, interval.end_sample / static_cast<float>(l));
        for (int axis = 0; axis < 2; ++axis) {
            interval.start[axis] = start.position[axis];
            interval.end[axis] = end.position[axis];
        }
        for (int axis = 0; axis < 3; ++axis) {
            interval.start_world[axis] = start_world[axis];
            interval.end_world[axis] = end_world[axis];
        }
        interval.start_depth = start.depth;
        interval.end_depth = end.depth;
        interval.start_arc = start.arc;
        interval.end_arc = end.arc;
    }

  private:
    /// Empty if the segment has no samples, or they are beyond the atlas.
    std::span<const std::uint8_t> samples_of(std::uint32_t i) const {
        const std::uint32_t s = in_.offsets[i];
        const std::uint32_t l = frame_.samples(i);
        if (l == 0 || l > in_.capacity || s > in_.capacity - l) return {};
        return in_.alpha.subspan(in_.layout.address(s), l);
    }

    std::uint32_t least_shown(std::uint32_t i) const {
        return LA_INTERVAL_SHOWN(in_.segments[i].tag & LA_TAG_KIND_MASK);
    }

    /// Whether the path is visible just beyond one end of a segment; `own` where it ends there.
    bool shown_beyond(std::uint32_t i, bool at_end, bool own) const {
        std::uint32_t neighbour = i;
        if (path_end(frame_, i, at_end, neighbour) != LA_END_JOIN) return own;
        const auto samples = samples_of(neighbour);
        return !samples.empty() &&
               (at_end ? samples.front() : samples.back()) >= least_shown(neighbour);
    }

    void find_in(std::uint32_t i) {
        const auto samples = samples_of(i);
        Piece piece{0, 1, LA_CHANGE_NONE, LA_CHANGE_NONE, false};
        if (samples.empty()) return put(i, samples, piece);
        const std::uint32_t least = least_shown(i);
        bool shown = samples.front() >= least;
        const auto change_at = [&](float place, std::uint32_t change, bool visible) {
            piece.end = place;
            piece.end_change = change;
            piece.visible = visible;
            put(i, samples, piece);
            piece.start = place;
            piece.start_change = change;
        };
        if (shown_beyond(i, false, shown) != shown) change_at(0.25F, LA_CHANGE_HEAD, !shown);
        for (std::size_t j = 1; j < samples.size(); ++j) {
            if ((samples[j] >= least) == shown) continue;
            change_at(static_cast<float>(j), LA_CHANGE_WITHIN, shown);
            shown = !shown;
        }
        const auto l = static_cast<float>(samples.size());
        piece.visible = shown;
        if (shown_beyond(i, true, shown) != shown) {
            change_at(l - 0.25F, LA_CHANGE_TAIL, shown);
            piece.visible = !shown;
        }
        piece.end = l;
        piece.end_change = LA_CHANGE_NONE;
        put(i, samples, piece);
    }

    void put(std::uint32_t i, std::span<const std::uint8_t> samples, const Piece& piece) {
        if (!piece.visible && !in_.hidden_too) return;
        Interval& interval = found_.emplace_back();
        interval.segment = i;
        interval.start_sample = piece.start;
        interval.end_sample = piece.end;
        interval.alpha = mean_alpha(samples, piece);
        interval.flags = (piece.visible ? LA_INTERVAL_VISIBLE : 0U) |
                         end_kind(i, false, piece.start_change) << LA_INTERVAL_START_SHIFT |
                         end_kind(i, true, piece.end_change) << LA_INTERVAL_END_SHIFT |
                         piece.start_change << LA_INTERVAL_START_CHANGE_SHIFT |
                         piece.end_change << LA_INTERVAL_END_CHANGE_SHIFT;
    }

    static float mean_alpha(std::span<const std::uint8_t> samples, const Piece& piece) {
        if (samples.empty()) return 0;
        const auto first = static_cast<std::uint32_t>(piece.start + 0.5F);
        const auto end = static_cast<std::uint32_t>(piece.end + 0.5F);
        if (first >= end) return piece.visible ? 1 : 0;
        std::uint32_t sum = 0;
        for (std::uint32_t j = first; j < end; ++j) sum += samples[j];
        return static_cast<float>(sum) / (255.0F * static_cast<float>(end - first));
    }

    std::uint32_t end_kind(std::uint32_t i, bool at_end, std::uint32_t change) const {
        std::uint32_t neighbour = i;
        if (change != LA_CHANGE_NONE) return LA_END_HIDDEN;
        return path_end(frame_, i, at_end, neighbour);
    }

    /// By the probes in a box one pixel wide and long.
    bool shown_at(const Line& line, float sample) const {
        std::uint32_t visible = 0;
        for (std::uint32_t probe = 0; probe < probes; ++probe) {
            const float across = static_cast<float>(probe % 3) - 1.0F;
            const float ahead = static_cast<float>(probe / 3) - 1.0F;
            const float side = across * (1.0F / 3.0F) + ahead * (1.0F / 9.0F);
            const float along = ahead * (1.0F / 3.0F) + across * (1.0F / 9.0F);
            const float u = (sample + along * line.pixel) * (1.0F / static_cast<float>(line.l));
            visible += sees_line(line.spine, u, side, depth_) ? 1 : 0;
        }
        return 255 * visible >= line.least * probes;
    }

    /// Where visibility changes. shown: visible before the change.
    float narrow(const Line& line, std::uint32_t change, float around, bool shown) const {
        if (change == LA_CHANGE_NONE) return around;
        float low = around - 0.5F;
        float high = around + 0.5F;
        const auto end = static_cast<float>(line.l);
        if (change == LA_CHANGE_HEAD) {
            if (shown_at(line, 0) != shown) return 0;
            low = 0;
            high = 0.5F;
        } else if (change == LA_CHANGE_TAIL) {
            if (shown_at(line, end) == shown) return end;
            low = end - 0.5F;
            high = end;
        }
        for (int step = 0; step < LA_INTERVAL_STEPS; ++step) {
            const float middle = 0.5F * (low + high);
            (shown_at(line, middle) == shown ? low : high) = middle;
        }
        return 0.5F * (low + high);
    }

    /// The point of the model at share u of what the screen shows of segment i.
    glm::vec3 world_point(std::uint32_t i, float u) const {
        const ClippedSegment& clipped = in_.clipped[i];
        const float wp = clipped.p[3];
        const float wq = clipped.q[3];
        const float along = u * wp / ((1.0F - u) * wq + u * wp);
        const float t = clipped.t0 + (clipped.t1 - clipped.t0) * along;
        const glm::vec3 p = in_.vertices[in_.segments[i].p];
        const glm::vec3 q = in_.vertices[in_.segments[i].q];
        return p + (q - p) * t;
    }

    const IntervalsInput& in_;
    FrameTables frame_;
    Depth depth_;
    std::vector<Interval> found_;
};

} // namespace

std::uint32_t intervals(const IntervalsInput& input, std::span<Interval> out) {
    Finder finder{input};
    std::vector<Interval> found = finder.find();
    if (found.size() <= out.size()) { // else none, as told
        for (Interval& interval : found) finder.refine(interval);
        std::ranges::copy(found, out.begin());
    }
    return static_cast<std::uint32_t>(found.size());
}

} // namespace lineatlas::compute::reference
