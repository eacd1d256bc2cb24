#include "filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/path_share.hpp"

namespace lineatlas::test::oracles {
namespace {

/// Nothing is shorter than this, in pixels, because arc lengths are rounded.
constexpr float shortest = 0.01F;
/// Samples that may fade out before an end.
constexpr std::uint32_t fading_samples = 8;

struct Span {
    float start, end;
};

/// A visible interval of a path in arc length, and its runs.
struct PathInterval {
    float start, end;
    std::uint32_t start_kind, end_kind; ///< LA_END_*
    std::size_t first_run, last_run;
    float start_overshoot = 0, end_overshoot = 0;
};

std::uint32_t stroke_end_kind(std::uint32_t kind) {
    return kind == LA_END_PATH || kind == LA_END_CLIPPED ? kind : LA_END_HIDDEN;
}

/// The samples at the two ends of a run.
std::uint32_t first_sample(const Run& run) {
    return run.start_sample > 0 ? static_cast<std::uint32_t>(run.start_sample + 0.5F) : 0;
}
std::uint32_t last_sample(const Run& run) {
    if (run.end_sample >= static_cast<float>(run.samples)) return run.samples - 1;
    return static_cast<std::uint32_t>(run.end_sample - 0.5F) - 1;
}

/// Filters one path: finds all its intervals, then strokes, then pieces of strokes, then runs.
class PathFilter {
  public:
    PathFilter(const FilterInput& in, std::size_t run_begin, std::size_t run_end,
               std::vector<Run>& out)
        : in_(in), frame_(in.frame), begin_(run_begin), end_(run_end), out_(out) {
        const FrameTables& frame = in.frame;
        const std::uint32_t segment = in.runs[run_begin].segment;
        first_ = segment - frame.segments[segment].from_start;
        last_ = segment + frame.segments[segment].to_end;
        half_length_ = static_cast<float>(frame.arcs[last_ + 1] - frame.arcs[first_]) *
                       (1.0F / LA_ARC_UNITS_PER_PIXEL) * 0.5F;
        seam_ = (frame.segments[first_].tag & LA_TAG_CLOSED) != 0 && frame.clipped[last_].t1 >= 1 &&
                frame.clipped[first_].t0 <= 0 && frame.is_drawn(last_) && frame.is_drawn(first_);
        overshoot_ = in.filter.overshoot *
                     (1 - in.filter.overshoot_variation * path_share(frame.segments[first_].path));
    }

    void run() {
        std::vector<PathInterval> intervals;
        for (std::size_t r = begin_; r < end_; ++r) intervals.push_back(interval_of(r));
        float seam_gap = std::numeric_limits<float>::infinity();
        if (seam_) seam_gap = intervals.front().start + 2 * half_length_ - intervals.back().end;
        seam_room_ = 0.5F * seam_gap;
        joined_ = seam_gap <= shortest || seam_gap < in_.filter.fill_holes;
        if (joined_) {
            intervals.front().start = -half_length_;
            intervals.front().start_kind = LA_END_JOIN;
            intervals.back().end = half_length_;
            intervals.back().end_kind = LA_END_JOIN;
        }
        intervals = merged(intervals, [&](const PathInterval& a, const PathInterval& b) {
            return b.start - a.end <= shortest || b.start - a.end < in_.filter.fill_holes;
        });
        std::erase_if(intervals, [&](const PathInterval& interval) {
            return !is_cut_off(interval.start_kind) && !is_cut_off(interval.end_kind) &&
                   interval.end - interval.start < in_.filter.drop_runs;
        });
        for (PathInterval& interval : intervals) set_overshoot(interval);
        intervals = merged(intervals, [&](const PathInterval& a, const PathInterval& b) {
            return b.start - a.end <=
                   a.end_overshoot + b.start_overshoot - 2 * in_.filter.undershoot;
        });
        for (const PathInterval& interval : intervals) emit(interval);
    }

  private:
    Span span(std::uint32_t i) const {
        const float start = frame_.arc(i);
        return {start, start + frame_.length(i)};
    }

    PathInterval interval_of(std::size_t r) const {
        const Run& run = in_.runs[r];
        const Span whole = span(run.segment);
        const auto l = static_cast<float>(run.samples);
        const auto share = [&](std::uint32_t j) {
            return static_cast<float>(in_.alpha[run.address + j]) * (1.0F / 255.0F);
        };
        const bool starts = !shown_across(frame_.segments, in_.runs, r, false);
        const bool ends = !shown_across(frame_.segments, in_.runs, r, true);
        const std::uint32_t a = first_sample(run), b = last_sample(run);
        float start = 0, end = l;
        if (starts && ends && a == b) {
            start = static_cast<float>(a) + 0.5F - 0.5F * share(a);
            end = static_cast<float>(a) + 0.5F + 0.5F * share(a);
        } else {
            if (starts) start = static_cast<float>(a + 1) - share(a);
            if (ends) end = static_cast<float>(b) + share(b);
        }
        const float per_sample = (whole.end - whole.start) / l;
        return {.start = starts ? whole.start + start * per_sample : whole.start,
                .end = ends ? whole.start + end * per_sample : whole.end,
                .start_kind = stroke_end_kind(run.flags >> LA_RUN_START_SHIFT & LA_END_MASK),
                .end_kind = stroke_end_kind(run.flags >> LA_RUN_END_SHIFT & LA_END_MASK),
                .first_run = r,
                .last_run = r};
    }

    bool connected(std::uint32_t from, std::uint32_t to) const {
        for (std::uint32_t i = from; i < to; ++i) {
            if (!frame_.goes_on(i)) return false;
        }
        return true;
    }

    template <class Meets>
    std::vector<PathInterval> merged(const std::vector<PathInterval>& intervals,
                                     Meets&& meets) const {
        std::vector<PathInterval> result;
        for (const PathInterval& next : intervals) {
            if (!result.empty() && meets(result.back(), next) &&
                connected(in_.runs[result.back().last_run].segment,
                          in_.runs[next.first_run].segment)) {
                result.back().end = next.end;
                result.back().end_kind = next.end_kind;
                result.back().last_run = next.last_run;
                result.back().end_overshoot = next.end_overshoot;
            } else {
                result.push_back(next);
            }
        }
        return result;
    }

    /// True if a stroke may go on beyond an end of this kind, so that its length is unknown.
    static bool is_cut_off(std::uint32_t kind) {
        return kind == LA_END_CLIPPED || kind == LA_END_JOIN;
    }

    /// Length of stroke that a run draws in a stretch, times its opacity.
    float ink_of(const Run& run, Span stretch) const {
        const Span whole = span(run.segment);
        const float per_sample = (whole.end - whole.start) / static_cast<float>(run.samples);
        const float from = (stretch.start - whole.start) / per_sample;
        const float to = (stretch.end - whole.start) / per_sample;
        const int last = static_cast<int>(run.samples) - 1;
        float sum = 0;
        for (int j = std::clamp(static_cast<int>(from), 0, last);
             j <= last && static_cast<float>(j) < to; ++j) {
            const std::uint8_t alpha = in_.alpha[run.address + static_cast<std::uint32_t>(j)];
            const float opacity =
                std::min(static_cast<float>(alpha) * (1.0F / LA_FULLY_SHOWN), 1.0F);
            sum +=
                (std::min(static_cast<float>(j + 1), to) - std::max(static_cast<float>(j), from)) *
                opacity;
        }
        return std::max(sum, 0.0F) * per_sample;
    }

    /// Length of stroke times opacity within the overshoot of a place, from run r on.
    float ink_near(std::size_t r, float place, bool forward) const {
        const float low = forward ? place : place - overshoot_;
        const float high = forward ? place + overshoot_ : place;
        float sum = 0, around = 0;
        for (std::size_t left = end_ - begin_; left > 0; --left) {
            const PathInterval own = interval_of(r);
            const Span stretch{std::max(own.start, low - around), std::min(own.end, high - around)};
            if (stretch.end < stretch.start) break;
            sum += ink_of(in_.runs[r], stretch);
            if (r == (forward ? end_ - 1 : begin_)) {
                if (!joined_) break;
                around += forward ? 2 * half_length_ : -2 * half_length_;
                r = forward ? begin_ : end_ - 1;
                continue;
            }
            const std::size_t a = forward ? r : r - 1;
            if (!connected(in_.runs[a].segment, in_.runs[a + 1].segment)) break;
            r = forward ? r + 1 : r - 1;
        }
        return sum;
    }

    /// Where the overshoot of run r's end starts: samples that fade out count by their opacity.
    float overshoot_start(std::size_t r, bool at_end, float end) const {
        if (shown_across(frame_.segments, in_.runs, r, at_end)) return end;
        const Run& run = in_.runs[r];
        const Span whole = span(run.segment);
        const float per_sample = (whole.end - whole.start) / static_cast<float>(run.samples);
        const std::uint32_t first = first_sample(run), last = last_sample(run);
        const std::uint32_t count = std::min(last - first + 1, fading_samples);
        float length = 0, opacity_after = 0;
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t j = at_end ? last - k : first + k;
            const std::uint8_t alpha = in_.alpha[run.address + j];
            const float share = static_cast<float>(alpha) * (1.0F / 255.0F);
            const float opacity =
                std::min(static_cast<float>(alpha) * (1.0F / LA_FULLY_SHOWN), 1.0F);
            length = std::max(share, std::min(opacity, opacity_after)) + opacity * length;
            if (alpha >= LA_FULLY_SHOWN) {
                const float position =
                    at_end ? static_cast<float>(j) + length : static_cast<float>(j + 1) - length;
                return whole.start + position * per_sample;
            }
            opacity_after = opacity;
        }
        return end;
    }

    float overshoot_beside(float ink) const { return std::min(ink * ink / overshoot_, overshoot_); }

    /// Sets the overshoot of an interval: less beside little ink, and never across a gap.
    void set_overshoot(PathInterval& interval) const {
        if (!(overshoot_ > 0)) return;
        float& at_start = interval.start_overshoot;
        float& at_end = interval.end_overshoot;
        const float start = overshoot_start(interval.first_run, false, interval.start);
        const float end = overshoot_start(interval.last_run, true, interval.end);
        const float before = overshoot_beside(ink_near(interval.first_run, start, true));
        const float after = overshoot_beside(ink_near(interval.last_run, end, false));
        at_start = std::max(before - (start - interval.start), 0.0F);
        at_end = std::max(after - (interval.end - end), 0.0F);
        for (const Span gap : gaps(interval)) {
            if (gap.start < interval.start) {
                at_start = std::clamp(interval.start - gap.end, 0.0F, at_start);
            }
            if (gap.end > interval.end) {
                at_end = std::clamp(gap.start - interval.end, 0.0F, at_end);
            }
        }
    }

    /// Emits a stroke at its final length, without the gaps in it.
    void emit(const PathInterval& interval) {
        float start = interval.start, end = interval.end;
        std::uint32_t start_kind = interval.start_kind, end_kind = interval.end_kind;
        if (start_kind == LA_END_PATH) start -= interval.start_overshoot;
        if (end_kind == LA_END_PATH) end += interval.end_overshoot;
        const auto grow = [&](float overshoot, bool at_seam) {
            const float by = overshoot - in_.filter.undershoot;
            return at_seam ? std::min(by, seam_room_) : by;
        };
        if (start_kind == LA_END_HIDDEN) {
            start -= grow(interval.start_overshoot, interval.first_run == begin_);
        }
        if (end_kind == LA_END_HIDDEN) {
            end += grow(interval.end_overshoot, interval.last_run + 1 == end_);
        }

        std::uint32_t i = in_.runs[interval.first_run].segment;
        while (i > first_ && span(i).start > start && frame_.goes_on(i - 1)) --i;
        const bool open_start = i == first_ && frame_.clipped[i].t0 <= 0;
        if (start < span(i).start && !open_start) {
            start = span(i).start;
            start_kind = LA_END_CLIPPED;
        }
        std::uint32_t last = in_.runs[interval.last_run].segment;
        while (last < last_ && span(last).end < end && frame_.goes_on(last)) ++last;
        const bool open_end = last == last_ && frame_.clipped[last].t1 >= 1;
        if (end > span(last).end && !open_end) {
            end = span(last).end;
            end_kind = LA_END_CLIPPED;
        }
        float least = shortest;
        for (const Span gap : gaps(interval)) {
            if (gap.end <= start || gap.start >= end) continue;
            least = std::max(in_.filter.drop_runs, shortest);
            if (is_cut_off(start_kind) || gap.start - start >= least) {
                emit_piece(i, start, gap.start, start_kind, LA_END_HIDDEN);
            }
            start = gap.end;
            start_kind = LA_END_HIDDEN;
        }
        if (is_cut_off(end_kind) || end - start >= least) {
            emit_piece(i, start, end, start_kind, end_kind);
        }
    }

    /// The gaps in an interval in ascending order. They may overlap.
    std::vector<Span> gaps(const PathInterval& interval) const {
        std::vector<Span> result;
        if (in_.cuts.empty()) return result;
        for (std::size_t r = interval.first_run; r <= interval.last_run; ++r) {
            for (int k = 0; k < LA_MOST_CUTS; ++k) {
                const Span gap{in_.cuts[r].from[k], in_.cuts[r].to[k]};
                if (gap.end > gap.start) result.push_back(gap);
            }
        }
        std::ranges::stable_sort(result, {}, &Span::start);
        return result;
    }

    void emit_piece(std::uint32_t i, float start, float end, std::uint32_t start_kind,
                    std::uint32_t end_kind) {
        if (end - start < shortest) return;
        const std::uint32_t kinds =
            start_kind << LA_STROKE_START_SHIFT | end_kind << LA_STROKE_END_SHIFT;
        // A loop without an end is entirely the middle of its stroke.
        const bool endless = start_kind == LA_END_JOIN && end_kind == LA_END_JOIN;
        const Span stroke = endless ? Span{-LA_ENDLESS, LA_ENDLESS} : Span{start, end};
        const float around = 2 * half_length_;
        const float to = end;
        float from = start;
        if (seam_ && from < -half_length_ - shortest) {
            std::uint32_t tail = last_;
            while (tail > first_ && span(tail).start > from + around && frame_.goes_on(tail - 1)) {
                --tail;
            }
            const bool all = to < -half_length_ + shortest;
            emit_part(
                tail, {std::max(from + around, span(tail).start), all ? to + around : half_length_},
                start_kind, all ? end_kind : LA_END_JOIN, {start + around, end + around}, kinds);
            if (all) return;
            from = -half_length_;
            start_kind = LA_END_JOIN;
        }
        if (seam_ && to > half_length_ + shortest) {
            const bool all = from > half_length_ - shortest;
            if (!all) {
                emit_part(forward(i, from), {from, half_length_}, start_kind, LA_END_JOIN,
                          {start, end}, kinds);
            }
            from = all ? from - around : -half_length_;
            emit_part(forward(first_, from), {from, to - around}, all ? start_kind : LA_END_JOIN,
                      end_kind, {start - around, end - around}, kinds);
            return;
        }
        emit_part(forward(i, from), {from, to}, start_kind, end_kind, stroke, kinds);
    }

    /// The first segment from i on that contains an arc length.
    std::uint32_t forward(std::uint32_t i, float arc) const {
        while (i < last_ && span(i).end < arc && frame_.goes_on(i)) ++i;
        return i;
    }

    /// The samples of segment i; none if the atlas is too small for them. Then the frame is drawn
    /// again.
    std::uint32_t samples_of(std::uint32_t i) const {
        const std::uint32_t l = frame_.samples(i);
        return l <= in_.capacity && frame_.offsets[i] <= in_.capacity - l ? l : 0;
    }

    /// Emits the runs of a part from segment i on.
    void emit_part(std::uint32_t i, Span part, std::uint32_t start_kind, std::uint32_t end_kind,
                   Span stroke, std::uint32_t kinds) {
        bool begins = true, ends = false;
        for (; !ends; ++i) {
            const Span whole = span(i);
            ends = part.end <= whole.end + shortest || i == last_ || !frame_.goes_on(i);
            if (begins && !ends && whole.end - part.start <= shortest) continue;
            const float lo = begins ? part.start : whole.start;
            const float hi = ends ? part.end : whole.end;
            const std::uint32_t l = samples_of(i);
            const std::uint32_t counted = std::max(l, 1U);
            const float per_pixel = static_cast<float>(counted) / (whole.end - whole.start);
            const float from = lo == whole.start ? 0 : (lo - whole.start) * per_pixel;
            const float to =
                hi == whole.end ? static_cast<float>(counted) : (hi - whole.start) * per_pixel;
            const bool joins_before = !begins || start_kind == LA_END_JOIN;
            const bool joins_after = !ends || end_kind == LA_END_JOIN;
            Run run = make_run(frame_, i, from, to, counted,
                               joins_before ? segment_end(frame_, i, false) : End{start_kind},
                               joins_after ? segment_end(frame_, i, true) : End{end_kind});
            constexpr std::uint32_t stroke_ends =
                LA_END_MASK << LA_STROKE_START_SHIFT | LA_END_MASK << LA_STROKE_END_SHIFT;
            run.flags = (run.flags & ~stroke_ends) | kinds | (l == 0 ? LA_RUN_SOLID : 0);
            run.stroke_start = stroke.start;
            run.stroke_end = stroke.end;
            run.address = l > 0 ? frame_.offsets[i] : 0;
            out_.push_back(run);
            begins = false;
        }
    }

    const FilterInput& in_;
    const FrameTables& frame_;
    std::size_t begin_, end_; ///< runs of the path
    std::vector<Run>& out_;
    std::uint32_t first_, last_; ///< segments of the path
    float half_length_;
    bool seam_;
    bool joined_ = false; ///< visible at its seam
    float overshoot_, seam_room_ = 0;
};

void show_samples(std::span<const Segment> segments, std::span<const Run> runs,
                  std::span<const Run> filtered, std::span<std::uint8_t> alpha) {
    for (const Run& run : filtered) {
        if ((run.flags & LA_RUN_SOLID) != 0) continue;
        // Beyond an end of the segment its last sample counts.
        const int most = static_cast<int>(run.samples) - 1;
        const int first =
            std::clamp(static_cast<int>(std::floor(run.start_sample - 0.5F)), 0, most);
        const int last =
            std::clamp(static_cast<int>(std::floor(run.end_sample - 0.5F)) + 1, 0, most);
        for (int j = first; j <= last; ++j) {
            std::uint8_t& sample = alpha[run.address + static_cast<std::uint32_t>(j)];
            if (sample == 0) sample = 255;
        }
    }
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const auto show = [&](std::uint32_t j) {
            std::uint8_t& sample = alpha[runs[r].address + j];
            sample = std::max<std::uint8_t>(sample, LA_FULLY_SHOWN);
        };
        if (!shown_across(segments, runs, r, false)) show(first_sample(runs[r]));
        if (!shown_across(segments, runs, r, true)) show(last_sample(runs[r]));
    }
}

} // namespace

FrameRecord filter(const FilterInput& in, std::span<std::uint8_t> alpha, std::span<Run> filtered,
                   const FrameRecord& record) {
    const std::span<const Segment> segments = in.frame.segments;
    std::vector<Run> result;
    for (std::size_t begin = 0; begin < in.runs.size();) {
        const std::uint32_t segment = in.runs[begin].segment;
        const std::uint32_t last = segment + segments[segment].to_end;
        std::size_t end = begin;
        while (end < in.runs.size() && in.runs[end].segment <= last) ++end;
        PathFilter{in, begin, end, result}.run();
        begin = end;
    }
    FrameRecord filtered_record = make_record(result.size(), filtered.size(), record.sample_total);
    filtered_record.raw_run_total = record.run_total;
    if (result.size() > filtered.size()) result.clear();
    std::ranges::copy(result, filtered.begin());
    show_samples(segments, in.runs, result, alpha);
    return filtered_record;
}

} // namespace lineatlas::test::oracles
