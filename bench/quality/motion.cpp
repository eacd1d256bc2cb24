#include "motion.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

namespace lineatlas::bench {
namespace {

/// The value at a position: linear between the centres of `l` samples, constant beyond them.
template <class T>
double interpolated(const T* samples, std::uint32_t l, double position) {
    const double x = std::clamp(position - 0.5, 0.0, l - 1.0);
    const auto low = static_cast<std::uint32_t>(x);
    const std::uint32_t high = std::min(low + 1, l - 1);
    const double a = samples[low], b = samples[high];
    return a + (b - a) * (x - low);
}

} // namespace

std::vector<Match> match_points(const ClippedLines& now, const ClippedLines& before,
                                glm::ivec2 viewport) {
    std::vector<Match> matches;
    for (std::uint32_t i = 0; i < now.clipped.size(); ++i) {
        const std::uint32_t l = now.samples(i);
        const std::uint32_t l_before = before.samples(i);
        if (l == 0 || l_before == 0) continue;
        const WindowSegment place = window_segment(now.clipped[i], viewport);
        const WindowSegment place_before = window_segment(before.clipped[i], viewport);
        for (std::uint32_t j = 0; j < l; ++j) {
            const double u = (j + 0.5) / l;
            const auto u_before = share_at(before.clipped[i], parameter_at(now.clipped[i], u));
            if (!u_before) continue;
            if (glm::distance(place.at(u), place_before.at(*u_before)) > fastest_pixels) continue;
            matches.push_back({i, j, static_cast<float>(*u_before * l_before)});
        }
    }
    return matches;
}

StrokeArcs::StrokeArcs(std::span<const Run> runs, std::size_t segment_count)
    : runs_(runs.begin(), runs.end()), first_(segment_count + 1) {
    std::ranges::sort(runs_, {}, [](const Run& run) {
        return std::tuple{run.segment, run.start_sample};
    });
    for (const Run& run : runs_) ++first_[run.segment + 1];
    for (std::size_t i = 0; i < segment_count; ++i) first_[i + 1] += first_[i];
}

std::optional<double> StrokeArcs::at(std::uint32_t segment, double position) const {
    for (std::uint32_t i = first_[segment]; i < first_[segment + 1]; ++i) {
        const Run& run = runs_[i];
        if (position < run.start_sample || position > run.end_sample) continue;
        const double length = double{run.end_sample} - run.start_sample;
        const double u = length > 0 ? (position - run.start_sample) / length : 0;
        return run.start_arc + (double{run.end_arc} - run.start_arc) * u;
    }
    return std::nullopt;
}

std::vector<Run> spine_runs(const ClippedLines& lines, std::span<const std::uint8_t> alpha,
                            glm::ivec2 viewport) {
    std::vector<Run> runs;
    for (std::uint32_t i = 0; i < lines.clipped.size(); ++i) {
        const std::uint32_t l = lines.samples(i);
        if (l == 0) continue;
        const WindowSegment place = window_segment(lines.clipped[i], viewport);
        const double length_px = glm::distance(place.p, place.q);
        const auto arc = [&](float sample) {
            return static_cast<float>((sample / l - 0.5) * length_px);
        };
        const auto own = alpha.subspan(lines.offsets[i], l);
        for (std::uint32_t j = 0; j < l; ++j) {
            if (own[j] == 0) continue;
            Run run{};
            run.segment = i;
            run.start_sample = static_cast<float>(j);
            while (j < l && own[j] != 0) ++j;
            run.end_sample = static_cast<float>(j);
            run.start_arc = arc(run.start_sample);
            run.end_arc = arc(run.end_sample);
            runs.push_back(run);
        }
    }
    return runs;
}

void MotionFigures::add(const MotionFigures& other) {
    points += other.points;
    sparkle_sum += other.sparkle_sum;
    stroke_points += other.stroke_points;
    crawl_sum += other.crawl_sum;
    crawling += other.crawling;
}

std::optional<double> MotionFigures::sparkle() const {
    if (points == 0) return std::nullopt;
    return sparkle_sum / static_cast<double>(points);
}

std::optional<double> MotionFigures::crawl() const {
    if (stroke_points == 0) return std::nullopt;
    return crawl_sum / static_cast<double>(stroke_points);
}

std::optional<double> MotionFigures::crawling_share() const {
    if (stroke_points == 0) return std::nullopt;
    return static_cast<double>(crawling) / static_cast<double>(stroke_points);
}

void KindMotion::add(const KindMotion& other) {
    all.add(other.all);
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i].add(other.kinds[i]);
}

KindMotion compare_frames(const LineSet& lines, std::span<const Match> matches,
                          const FrameView& now, const FrameView& before) {
    KindMotion figures;
    for (const Match& match : matches) {
        const std::uint32_t i = now.clipped.offsets[match.segment] + match.sample;
        const std::uint32_t begin = before.clipped.offsets[match.segment];
        const std::uint32_t l = before.clipped.samples(match.segment);
        const double alpha_before = interpolated(&before.alpha[begin], l, match.before);
        const double truth_before = interpolated(&before.truth[begin], l, match.before);
        const double alpha_change = (now.alpha[i] - alpha_before) / 255;
        const double truth_change = now.truth[i] - truth_before;
        MotionFigures point{.points = 1, .sparkle_sum = std::abs(alpha_change - truth_change)};
        const auto arc = now.arcs.at(match.segment, match.sample + 0.5);
        const auto arc_before = before.arcs.at(match.segment, match.before);
        if (arc && arc_before) {
            point.stroke_points = 1;
            point.crawl_sum = std::abs(*arc - *arc_before);
            point.crawling = point.crawl_sum >= 0.5 ? 1 : 0;
        }
        figures.all.add(point);
        figures.kinds[lines.segments[match.segment].tag & LA_TAG_KIND_MASK].add(point);
    }
    return figures;
}

} // namespace lineatlas::bench
