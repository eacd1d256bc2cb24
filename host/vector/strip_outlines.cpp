#include <algorithm>
#include <limits>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "strips.hpp"

namespace lineatlas {
namespace {

/// Stretches with less than this between them are one, and shorter ones are none unless they are
/// the whole strip: within half a pixel of a corner the place beside a line is beside another.
constexpr double least_outline = 2; // pixels

using PartsOfSegment = std::unordered_multimap<std::uint32_t, const OutlinePart*>;

/// Where along a segment a window position lies, as a share of its way.
double share_along(const ScreenSegment& segment, glm::vec2 window, double height) {
    const glm::dvec2 way = segment.q.at - segment.p.at;
    const glm::dvec2 offset =
        glm::dvec2{double{window.x}, height - double{window.y}} - segment.p.at;
    return std::clamp(glm::dot(offset, way) / glm::dot(way, way), 0.0, 1.0);
}

void add_stretches(Strip& strip, const Pieces& pieces, const PartsOfSegment& parts, double height) {
    for (const StripStep& step : strip.steps) {
        const ScreenSegment& segment = pieces.screen[step.screen];
        if (!(segment.length > 0)) continue;
        const auto [first, last] = parts.equal_range(step.segment);
        for (auto part = first; part != last; ++part) {
            double from = share_along(segment, part->second->start, height);
            double to = share_along(segment, part->second->end, height);
            if (step.reversed) {
                from = 1 - from;
                to = 1 - to;
            }
            strip.outlines.push_back({step.start + std::min(from, to) * segment.length,
                                      step.start + std::max(from, to) * segment.length});
        }
    }
}

/// Sorted, joined over short gaps, without short ones.
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
    std::erase_if(joined, [&](const Stretch& stretch) {
        const bool at_seam =
            over_seam && (stretch.from < same_place || stretch.to > strip.length - same_place);
        return !at_seam && stretch.to - stretch.from < enough;
    });
    // What overshoots the strip is as its end is.
    for (Stretch& stretch : joined) {
        constexpr double far = std::numeric_limits<double>::infinity();
        if (stretch.from < least_outline) stretch.from = strip.closed ? 0 : -far;
        if (stretch.to > strip.length - least_outline)
            stretch.to = strip.closed ? strip.length : far;
    }
    stretches = std::move(joined);
}

} // namespace

void mark_outlines(std::vector<Strip>& strips, const Pieces& pieces,
                   std::span<const OutlinePart> outlines, double picture_height) {
    PartsOfSegment parts;
    for (const OutlinePart& part : outlines) parts.emplace(part.segment, &part);
    if (parts.empty()) return;
    for (Strip& strip : strips) {
        add_stretches(strip, pieces, parts, picture_height);
        tidy(strip);
    }
}

} // namespace lineatlas
