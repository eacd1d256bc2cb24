#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <ranges>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "segment_grid.hpp"
#include "strips.hpp"

namespace lineatlas {
namespace {

/// Stretches with less than this between them are one stretch. Shorter stretches do not count
/// unless they are the whole strip: within half a pixel of a corner the place beside a line is
/// beside another line.
constexpr double least_outline = 2; // pixels

using PartsOfSegment = std::unordered_multimap<std::uint32_t, const OutlinePart*>;

/// The rest of a stroke beyond a stretch is outline too if it is no longer than this. Where a line
/// disappears behind something, the background beside it gets too narrow.
constexpr double longest_remainder = 4; // pixels

glm::dvec2 from_above(glm::vec2 window, double height) {
    return {window.x, height - double{window.y}};
}

/// The share of a segment's way at which a place lies; below 0 or above 1 beyond its ends.
double share_along(const ScreenSegment& segment, glm::dvec2 place) {
    const glm::dvec2 way = segment.q.at - segment.p.at;
    return glm::dot(place - segment.p.at, way) / glm::dot(way, way);
}

void add_stretches(Strip& strip, const Pieces& pieces, const PartsOfSegment& parts, double height) {
    for (const StripStep& step : strip.steps) {
        const ScreenSegment& segment = pieces.screen[step.screen];
        if (!(segment.length > 0)) continue;
        const auto [first, last] = parts.equal_range(step.segment);
        for (auto part = first; part != last; ++part) {
            double from = share_along(segment, from_above(part->second->start, height));
            double to = share_along(segment, from_above(part->second->end, height));
            // A silhouette on a known surface has several chords in one triangle.
            if (std::max(from, to) <= 0 || std::min(from, to) >= 1) continue;
            from = std::clamp(from, 0.0, 1.0);
            to = std::clamp(to, 0.0, 1.0);
            if (step.reversed) {
                from = 1 - from;
                to = 1 - to;
            }
            strip.outlines.push_back({step.start + std::min(from, to) * segment.length,
                                      step.start + std::max(from, to) * segment.length});
        }
    }
}

/// Sorts the stretches of a strip, joins them over short gaps, and drops short ones.
void tidy(Strip& strip) {
    std::vector<Stretch>& stretches = strip.outlines;
    std::ranges::sort(stretches, {}, &Stretch::from);
    std::vector<Stretch> joined;
    for (const Stretch stretch : stretches) {
        if (!joined.empty() && stretch.from - joined.back().to < least_outline)
            joined.back().to = std::max(joined.back().to, stretch.to);
        else
            joined.push_back(stretch);
    }
    const double enough = std::min(least_outline, strip.length - same_place);
    const bool over_seam = strip.closed && !joined.empty() && joined.front().from < same_place &&
                           joined.back().to > strip.length - same_place;
    const auto length = [](const Stretch& stretch) { return stretch.to - stretch.from; };
    const double over = over_seam ? length(joined.front()) + length(joined.back()) : 0;
    std::erase_if(joined, [&](const Stretch& stretch) {
        const bool at_seam =
            over_seam && (stretch.from < same_place || stretch.to > strip.length - same_place);
        return (at_seam ? over : length(stretch)) < enough;
    });
    // Overshoots of the strip are like its ends.
    for (Stretch& stretch : joined) {
        constexpr double far = std::numeric_limits<double>::infinity();
        if (stretch.from < least_outline) stretch.from = strip.closed ? 0 : -far;
        if (stretch.to > strip.length - least_outline)
            stretch.to = strip.closed ? strip.length : far;
    }
    stretches = std::move(joined);
}

void add_remainders(Strip& strip) {
    for (const Stroke& stroke : strip.strokes) {
        if (!stroke.visible) continue;
        for (Stretch& stretch : strip.outlines) {
            const double most = std::min(longest_remainder, stretch.to - stretch.from);
            if (stretch.from > stroke.from && stretch.from - stroke.from < most)
                stretch.from = stroke.from;
            if (stretch.to < stroke.to && stroke.to - stretch.to < most) stretch.to = stroke.to;
        }
    }
}

/// The step at a place of a strip, or the first one.
std::vector<StripStep>::const_iterator step_at(const Strip& strip, double place) {
    const auto after = std::ranges::upper_bound(strip.steps, place, {}, &StripStep::start);
    return after == strip.steps.begin() ? after : std::prev(after);
}

/// A part of a stretch with the same ground beside it all along: `model` if no background is there.
struct Run {
    double from, to; ///< pixels from the strip's start; beyond its end across the seam
    Ground ground;
};

void add_run(std::vector<Run>& runs, Run run) {
    if (!runs.empty() && runs.back().ground == run.ground)
        runs.back().to = run.to;
    else
        runs.push_back(run);
}

/// The ground beside a line, on either side.
Ground beside(glm::dvec2 place, glm::dvec2 off, const Background& background) {
    const Ground left = background.at(place + off), right = background.at(place - off);
    for (const Ground ground : {Ground::around, Ground::enclosed})
        if (left == ground || right == ground) return ground;
    return Ground::model;
}

/// Adds the runs of a stretch, with `shift` added to their places.
void add_runs(const Strip& strip, Stretch stretch, double shift, const Pieces& pieces,
              const Background& background, std::vector<Run>& runs) {
    // Far enough for a texel that is not on the line.
    const double reach = 1.5 * background.texel();
    for (auto step = step_at(strip, stretch.from); step != strip.steps.end(); ++step) {
        if (step->start >= stretch.to) break;
        const ScreenSegment& segment = pieces.screen[step->screen];
        if (!(segment.length > 0)) continue;
        const glm::dvec2 way = (segment.q.at - segment.p.at) / segment.length;
        const glm::dvec2 off = reach * glm::dvec2{-way.y, way.x};
        const double from = std::max(stretch.from - step->start, 0.0);
        const double to = std::min(stretch.to - step->start, segment.length);
        const double count = std::ceil((to - from) / background.texel());
        for (double i = 0; i < count; ++i) {
            const double start = from + (to - from) * i / count;
            const double end = from + (to - from) * (i + 1) / count;
            const double middle = 0.5 * (start + end);
            const glm::dvec2 place =
                segment.p.at + way * (step->reversed ? segment.length - middle : middle);
            add_run(runs, {shift + step->start + start, shift + step->start + end,
                           beside(place, off, background)});
        }
    }
}

/// Gives the place of a run to its neighbours, half to each, and joins these if they are alike.
void remove_run(std::vector<Run>& runs, std::vector<Run>::iterator run) {
    const auto next = std::next(run);
    if (run == runs.begin()) {
        next->from = run->from;
    } else if (next == runs.end()) {
        std::prev(run)->to = run->to;
    } else if (std::prev(run)->ground == next->ground) {
        std::prev(run)->to = next->to;
        runs.erase(run, std::next(next));
        return;
    } else {
        std::prev(run)->to = next->from = 0.5 * (run->from + run->to);
    }
    runs.erase(run);
}

/// Lets runs without background, and then runs shorter than `least`, follow their neighbours.
void remove_short(std::vector<Run>& runs, double least) {
    for (std::size_t i = 0; i < runs.size() && runs.size() > 1;) {
        if (runs[i].ground == Ground::model)
            remove_run(runs, runs.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
    while (runs.size() > 1) {
        const auto shortest =
            std::ranges::min_element(runs, {}, [](const Run& run) { return run.to - run.from; });
        if (shortest->to - shortest->from >= least) return;
        remove_run(runs, shortest);
    }
}

/// The runs of a stretch, which may go on beyond the seam.
std::vector<Run> runs_of(const Strip& strip, Stretch stretch, const Pieces& pieces,
                         const Background& background) {
    std::vector<Run> runs;
    const bool over_seam = strip.closed && stretch.to > strip.length;
    const Stretch before{stretch.from, over_seam ? strip.length : stretch.to};
    add_runs(strip, before, 0, pieces, background, runs);
    if (over_seam)
        add_runs(strip, {0, stretch.to - strip.length}, strip.length, pieces, background, runs);
    return runs;
}

/// The stretches of a strip. Those on either side of a seam are one that goes on beyond it.
std::vector<Stretch> joined_over_seam(const Strip& strip) {
    std::vector<Stretch> stretches = strip.outlines;
    if (strip.closed && stretches.size() > 1 && stretches.front().from <= 0 &&
        stretches.back().to >= strip.length) {
        stretches.back().to = strip.length + stretches.front().to;
        stretches.erase(stretches.begin());
    }
    return stretches;
}

/// Lets a closed line that is outline all around begin where the ground changes. Returns the
/// stretch of its runs.
Stretch begin_at_change(const Strip& strip, Stretch stretch, std::vector<Run>& runs) {
    const bool is_all = strip.closed && stretch.from <= 0 && stretch.to >= strip.length;
    if (!is_all || runs.size() < 2 || runs.front().ground != runs.back().ground) return stretch;
    const double start = runs.front().to;
    runs.back().to = start + strip.length;
    runs.erase(runs.begin());
    return {start, start + strip.length};
}

/// Adds a stretch that may go on beyond the seam.
void add_stretch(Strip& strip, Stretch stretch) {
    const double seam = strip.closed ? strip.length : std::numeric_limits<double>::infinity();
    if (stretch.from < seam) strip.outlines.push_back({stretch.from, std::min(stretch.to, seam)});
    if (stretch.to > seam)
        strip.outlines.push_back({std::max(stretch.from, seam) - seam, stretch.to - seam});
}

/// Removes what is beside background that the model surrounds.
void leave_out_rims(Strip& strip, const Pieces& pieces, const Background& background) {
    const double least = 8 * background.texel(); // shorter changes of the ground do not count
    const std::vector<Stretch> stretches = joined_over_seam(strip);
    strip.outlines.clear();
    for (const Stretch of_strip : stretches) {
        std::vector<Run> runs = runs_of(strip, of_strip, pieces, background);
        const Stretch stretch = begin_at_change(strip, of_strip, runs);
        remove_short(runs, least);
        if (runs.empty()) runs.push_back({stretch.from, stretch.to, Ground::model});
        runs.front().from = stretch.from;
        runs.back().to = stretch.to;
        for (const Run& run : runs)
            if (run.ground != Ground::enclosed) add_stretch(strip, {run.from, run.to});
    }
    std::ranges::sort(strip.outlines, {}, &Stretch::from);
}

glm::dvec2 start_of(const StripStep& step, const Pieces& pieces) {
    const ScreenSegment& segment = pieces.screen[step.screen];
    return step.reversed ? segment.q.at : segment.p.at;
}

glm::dvec2 end_of(const StripStep& step, const Pieces& pieces) {
    const ScreenSegment& segment = pieces.screen[step.screen];
    return step.reversed ? segment.p.at : segment.q.at;
}

/// Where silhouettes end.
class SilhouetteEnds {
  public:
    SilhouetteEnds(const std::vector<Strip>& strips, const Pieces& pieces, glm::dvec2 picture)
        : pieces_(pieces), grid_(picture) {
        for (const Strip& strip : strips) {
            if (strip.kind != LineKind::silhouette || strip.closed || strip.steps.empty()) continue;
            add_end(start_of(strip.steps.front(), pieces), strip.steps,
                    [&](const StripStep& step) { return end_of(step, pieces); });
            add_end(end_of(strip.steps.back(), pieces), std::views::reverse(strip.steps),
                    [&](const StripStep& step) { return start_of(step, pieces); });
        }
    }

    /// Moves the ends of the stretches of a strip to silhouettes that end beside them on the strip.
    void draw_near(Strip& strip) {
        if (strip.kind == LineKind::silhouette) return;
        constexpr double far = std::numeric_limits<double>::infinity();
        std::vector<Stretch> moved;
        for (auto stretch = strip.outlines.begin(); stretch != strip.outlines.end(); ++stretch) {
            const auto next = std::next(stretch);
            const double low = moved.empty() ? -far : moved.back().to;
            const double high = next == strip.outlines.end() ? far : next->from;
            const double from = std::max(nearest(strip, stretch->from), low);
            const double to = std::min(nearest(strip, stretch->to), high);
            const Stretch now = from < to ? Stretch{from, to} : *stretch;
            if (!moved.empty() && now.from <= low)
                moved.back().to = now.to;
            else
                moved.push_back(now);
        }
        strip.outlines = std::move(moved);
    }

  private:
    /// A touching silhouette ends this near to the chords of the edge, pixels.
    static constexpr double reach = 0.25;
    /// A stretch is this much too long or too short at most, pixels, and ends where the edge is so
    /// far from the silhouette at most. The background is looked for half a pixel beside lines.
    static constexpr double longest_touch = 32, widest_touch = 1;
    /// Points nearer to an end than this tell no direction, pixels.
    static constexpr double least_way = 1;

    struct End {
        glm::dvec2 at, before; ///< the last point of a silhouette, and one further inwards
    };

    /// Adds an end unless the whole silhouette is within `least_way` of it. steps: from the end
    /// inwards. inner_end: gives the inner end of a step.
    template <class Steps, class InnerEnd>
    void add_end(glm::dvec2 at, const Steps& steps, const InnerEnd& inner_end) {
        for (const StripStep& step : steps) {
            const glm::dvec2 before = inner_end(step);
            if (glm::distance(at, before) < least_way) continue;
            grid_.insert(at, at, static_cast<std::uint32_t>(ends_.size()));
            ends_.push_back({at, before});
            return;
        }
    }

    glm::dvec2 point_at(const Strip& strip, double place) const {
        const StripStep& step = *step_at(strip, place);
        const double length = pieces_.screen[step.screen].length;
        const double share = length > 0 ? (place - step.start) / length : 0;
        return glm::mix(start_of(step, pieces_), end_of(step, pieces_), share);
    }

    static bool is_beside(glm::dvec2 at, const End& end) {
        const glm::dvec2 way = end.before - end.at, to = at - end.at;
        return std::abs(way.x * to.y - way.y * to.x) <= widest_touch * glm::length(way);
    }

    /// The place nearest to the given one at which a silhouette ends that passes beside the given
    /// one; else the given place.
    double nearest(const Strip& strip, double place) {
        if (!(place > 0 && place < strip.length)) return place;
        const glm::dvec2 beside = point_at(strip, place);
        double best = place, least = longest_touch;
        for (auto step = step_at(strip, place - least); step != strip.steps.end(); ++step) {
            if (step->start > place + least) break;
            const double length = pieces_.screen[step->screen].length;
            if (!(length > 0)) continue;
            const glm::dvec2 a = start_of(*step, pieces_), b = end_of(*step, pieces_);
            for (const std::uint32_t i : grid_.near(a, b, reach)) {
                const End& end = ends_[i];
                const double share =
                    std::clamp(glm::dot(end.at - a, b - a) / (length * length), 0.0, 1.0);
                const double at = step->start + share * length;
                if (std::abs(at - place) >= least || !is_beside(beside, end) ||
                    glm::distance(glm::mix(a, b, share), end.at) > reach)
                    continue;
                best = at;
                least = std::abs(at - place);
            }
        }
        return best;
    }

    const Pieces& pieces_;
    SegmentGrid grid_;
    std::vector<End> ends_;
};

} // namespace

void mark_outlines(std::vector<Strip>& strips, const Pieces& pieces,
                   std::span<const OutlinePart> outlines, glm::dvec2 picture,
                   const Background& background) {
    PartsOfSegment parts;
    for (const OutlinePart& part : outlines) parts.emplace(part.segment, &part);
    if (parts.empty()) return;
    SilhouetteEnds ends{strips, pieces, picture};
    for (Strip& strip : strips) {
        add_stretches(strip, pieces, parts, picture.y);
        tidy(strip);
        leave_out_rims(strip, pieces, background);
        ends.draw_near(strip);
        add_remainders(strip);
    }
}

} // namespace lineatlas
