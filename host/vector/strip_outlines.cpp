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

/// How much of a stretch lies beside which background, in pixels.
struct Beside {
    double around = 0, enclosed = 0;
};

/// Adds what lies beside a part of a segment, by shares of its way.
void add_beside(const ScreenSegment& segment, double from, double to, const Background& background,
                Beside& beside) {
    constexpr double step = 4; // pixels
    // Far enough for a texel that is not on the line.
    const double reach = 1.5 * background.texel();
    const glm::dvec2 way = segment.q.at - segment.p.at;
    const glm::dvec2 off = reach / segment.length * glm::dvec2{-way.y, way.x};
    const double length = (to - from) * segment.length;
    const double count = std::ceil(length / step);
    for (double i = 0.5; i < count; ++i) {
        const glm::dvec2 place = segment.p.at + way * (from + (to - from) * i / count);
        const Ground left = background.at(place + off), right = background.at(place - off);
        if (left == Ground::around || right == Ground::around)
            beside.around += length / count;
        else if (left == Ground::enclosed || right == Ground::enclosed)
            beside.enclosed += length / count;
    }
}

bool is_rim_of_hole(const Strip& strip, Stretch stretch, const Pieces& pieces,
                    const Background& background) {
    Beside beside;
    for (const StripStep& step : strip.steps) {
        const ScreenSegment& segment = pieces.screen[step.screen];
        if (!(segment.length > 0)) continue;
        double from = std::clamp((stretch.from - step.start) / segment.length, 0.0, 1.0);
        double to = std::clamp((stretch.to - step.start) / segment.length, 0.0, 1.0);
        if (!(from < to)) continue;
        if (step.reversed) {
            from = 1 - from;
            to = 1 - to;
            std::swap(from, to);
        }
        add_beside(segment, from, to, background, beside);
    }
    return beside.enclosed > beside.around;
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
        for (Stretch& stretch : strip.outlines) {
            const double from = nearest(strip, stretch.from), to = nearest(strip, stretch.to);
            if (from < to) stretch = {from, to};
        }
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
        const auto after = std::ranges::upper_bound(strip.steps, place, {}, &StripStep::start);
        const StripStep& step = after == strip.steps.begin() ? *after : *std::prev(after);
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
        for (const StripStep& step : strip.steps) {
            const double length = pieces_.screen[step.screen].length;
            if (!(length > 0) || step.start > place + least || step.start + length < place - least)
                continue;
            const glm::dvec2 a = start_of(step, pieces_), b = end_of(step, pieces_);
            for (const std::uint32_t i : grid_.near(a, b, reach)) {
                const End& end = ends_[i];
                const double share =
                    std::clamp(glm::dot(end.at - a, b - a) / (length * length), 0.0, 1.0);
                const double at = step.start + share * length;
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
        std::erase_if(strip.outlines, [&](Stretch stretch) {
            return is_rim_of_hole(strip, stretch, pieces, background);
        });
        ends.draw_near(strip);
        add_remainders(strip);
    }
}

} // namespace lineatlas
