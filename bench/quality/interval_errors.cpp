#include "interval_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "shared/constants.h"
#include "vector/junctions.hpp"
#include "vector/pieces.hpp"

namespace lineatlas::bench {
namespace {

/// One path from its start: its places, with a value of the truth each, and its intervals.
class Path {
  public:
    /// Adds a segment of `pixels`, with places of equal length.
    void add_segment(double pixels, std::span<const float> truth, std::uint32_t kind) {
        begin_ = end_;
        end_ += pixels;
        const double each = pixels / static_cast<double>(truth.size());
        for (std::size_t j = 0; j < truth.size(); ++j) {
            places_.push_back({.at = begin_ + (static_cast<double>(j) + 0.5) * each,
                               .length = each,
                               .alpha = truth[j],
                               .truly_visible = truth[j] * 255 >= LA_INTERVAL_SHOWN(kind)});
        }
    }

    /// Adds an interval between two shares of the last segment.
    void add_interval(double from, double to, bool visible, float alpha) {
        const double pixels = end_ - begin_;
        shares_ += (to - from) * pixels * double{alpha};
        const double start = begin_ + from * pixels;
        const double end = begin_ + to * pixels;
        if (!pieces_.empty() && pieces_.back().visible == visible &&
            std::abs(pieces_.back().end - start) < 1e-3) {
            pieces_.back().end = end;
        } else {
            pieces_.push_back({start, end, visible});
        }
    }

    IntervalFigures figures() const {
        IntervalFigures result;
        result.shares = shares_;
        std::size_t k = 0;
        for (const Place& place : places_) {
            result.length += place.length;
            result.true_shares += place.length * double{place.alpha};
            if (place.truly_visible) result.truly_visible += place.length;
            while (k < pieces_.size() && pieces_[k].end < place.at) ++k;
            const bool known = k < pieces_.size() && pieces_[k].start <= place.at;
            if (!known) {
                result.missing += place.length;
                continue;
            }
            if (pieces_[k].visible && !place.truly_visible) result.falsely_visible += place.length;
            if (!pieces_[k].visible && place.truly_visible) result.falsely_hidden += place.length;
        }
        const std::vector<double> changes = true_changes();
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const Piece& piece = pieces_[i];
            if (piece.visible) {
                result.visible += piece.end - piece.start;
                if (piece.end - piece.start < 1 && !truly_visible_in(piece)) ++result.crumbs;
            }
            if (i == 0 || std::abs(pieces_[i - 1].end - piece.start) > 1e-3) continue;
            ++result.ends;
            const double error = distance_to(changes, piece.start);
            if (error <= end_reach_pixels) result.errors.push_back(error);
        }
        return result;
    }

  private:
    struct Place {
        double at, length;
        float alpha;
        bool truly_visible;
    };
    struct Piece {
        double start, end;
        bool visible;
    };

    std::vector<double> true_changes() const {
        std::vector<double> result;
        for (std::size_t j = 1; j < places_.size(); ++j) {
            if (places_[j].truly_visible == places_[j - 1].truly_visible) continue;
            result.push_back(places_[j].at - 0.5 * places_[j].length);
        }
        return result;
    }

    static double distance_to(const std::vector<double>& sorted, double value) {
        const auto above = std::ranges::lower_bound(sorted, value);
        double nearest = std::numeric_limits<double>::infinity();
        if (above != sorted.end()) nearest = *above - value;
        if (above != sorted.begin()) nearest = std::min(nearest, value - *std::prev(above));
        return nearest;
    }

    /// True if a place in the piece, or at most truth_step_pixels from it, is truly visible.
    bool truly_visible_in(const Piece& piece) const {
        const auto first = std::ranges::lower_bound(
            places_, piece.start - double{truth_step_pixels}, {}, &Place::at);
        return std::any_of(first, places_.end(), [&](const Place& place) {
            return place.at <= piece.end + double{truth_step_pixels} && place.truly_visible;
        });
    }

    double shares_ = 0;
    double begin_ = 0, end_ = 0; ///< of the last segment
    std::vector<Place> places_;
    std::vector<Piece> pieces_;
};

} // namespace

double IntervalFigures::ends_within(double pixels) const {
    if (ends == 0) return 1;
    const auto near = std::ranges::count_if(errors, [&](double error) { return error <= pixels; });
    return static_cast<double>(near) / static_cast<double>(ends);
}

void IntervalFigures::add(const IntervalFigures& other) {
    length += other.length;
    visible += other.visible;
    truly_visible += other.truly_visible;
    shares += other.shares;
    true_shares += other.true_shares;
    falsely_visible += other.falsely_visible;
    falsely_hidden += other.falsely_hidden;
    crumbs += other.crumbs;
    ends += other.ends;
    errors.insert(errors.end(), other.errors.begin(), other.errors.end());
    missing += other.missing;
}

std::vector<Interval> met_intervals(const LineSet& lines, const ClippedLines& clipped,
                                    const Camera& camera, std::span<const Interval> intervals) {
    Pieces pieces = make_pieces(lines, camera, intervals);
    drop_flickers(pieces);
    meet_junctions(lines, camera, pieces);
    std::vector<Interval> result;
    for (const Piece& piece : pieces.list) {
        const ClippedSegment& segment = clipped.clipped[piece.segment];
        const WindowSegment window = window_segment(segment, camera.size);
        const glm::dvec2 way = window.q - window.p;
        const auto share = [&](glm::dvec2 at) {
            const glm::dvec2 place{at.x, camera.size.y - at.y}; // there y points down
            const double squared = glm::dot(way, way);
            return squared > 0 ? glm::dot(place - window.p, way) / squared : 0;
        };
        Interval interval{};
        interval.segment = piece.segment;
        interval.start_sample = static_cast<float>(share(pieces.start(piece).at));
        interval.end_sample = static_cast<float>(share(pieces.end(piece).at));
        interval.alpha = piece.alpha;
        interval.flags = piece.visible ? LA_INTERVAL_VISIBLE : 0;
        result.push_back(interval);
    }
    return result;
}

IntervalFigures compare_intervals(const LineSet& lines, const ClippedLines& fine,
                                  glm::ivec2 viewport, std::span<const float> truth,
                                  std::span<const Interval> intervals) {
    IntervalFigures result;
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < lines.segments.size();) {
        Path path;
        const std::uint32_t path_end = i + lines.segments[i].to_end + 1;
        for (; i < path_end; ++i) {
            const std::uint32_t places = fine.samples(i);
            if (places == 0) continue;
            const WindowSegment window = window_segment(fine.clipped[i], viewport);
            path.add_segment(glm::distance(window.p, window.q),
                             truth.subspan(fine.offsets[i], places),
                             lines.segments[i].tag & LA_TAG_KIND_MASK);
            while (next < intervals.size() && intervals[next].segment < i) ++next;
            const std::size_t first = next;
            while (next < intervals.size() && intervals[next].segment == i) ++next;
            if (first == next) continue; // its length counts as missing
            const double samples = intervals[next - 1].end_sample;
            for (const Interval& interval : intervals.subspan(first, next - first)) {
                path.add_interval(interval.start_sample / samples, interval.end_sample / samples,
                                  (interval.flags & LA_INTERVAL_VISIBLE) != 0, interval.alpha);
            }
        }
        result.add(path.figures());
    }
    return result;
}

} // namespace lineatlas::bench
