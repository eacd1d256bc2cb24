#include "chaining.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace lineatlas {
namespace {

/// Places along a strip are the same within this, pixels: rounding.
constexpr double rounding = 1e-6;

/// The strokes of a closed strip with those that meet at its seam joined: what is left of the
/// last one goes on beyond the strip's length.
std::vector<Stroke> across_seam(const Strip& strip) {
    std::vector<Stroke> strokes = strip.strokes;
    if (!strip.closed || strokes.size() < 2) return strokes;
    Stroke& first = strokes.front();
    const Stroke last = strokes.back();
    const bool meet =
        first.visible == last.visible && first.from + strip.length - last.to < same_place;
    if (!meet) return strokes;
    first.from = last.from - strip.length;
    first.start_kind = last.start_kind;
    strokes.pop_back();
    return strokes;
}

class PathMaker {
  public:
    PathMaker(const LineSet& lines, const Pieces& pieces, const Strip& strip)
        : lines_(lines), pieces_(pieces), strip_(strip) {}

    VectorPath make(const Stroke& stroke) const {
        VectorPath path{.kind = strip_.kind,
                        .visible = stroke.visible,
                        .alpha = stroke.alpha,
                        .points = {},
                        .pieces = {}};
        if (!strip_.closed) {
            add_part(path, stroke.from, stroke.to, 0);
            return path;
        }
        path.closed = stroke.length() > strip_.length - same_place;
        const double to = path.closed ? stroke.from + strip_.length : stroke.to;
        for (double lap = std::floor(stroke.from / strip_.length); lap * strip_.length < to;
             ++lap) {
            const double passed = lap * strip_.length;
            add_part(path, std::max(stroke.from - passed, 0.0),
                     std::min(to - passed, strip_.length), passed);
        }
        // Bit by bit, whatever rounding made of it.
        if (path.closed) path.points.back().at = path.points.front().at;
        return path;
    }

  private:
    /// Adds what lies between two places of one lap; beyond the strip's ends straight on.
    void add_part(VectorPath& path, double from, double to, double passed) const {
        if (to - from <= rounding) return;
        const auto after =
            std::ranges::upper_bound(strip_.steps, from + rounding, {}, &StripStep::start);
        auto step = after == strip_.steps.begin() ? after : std::prev(after);
        double at = from;
        for (; at < to - rounding; ++step) {
            const auto next = std::next(step);
            const bool last = next == strip_.steps.end();
            const double end = last ? to : std::min(to, next->start);
            if (end - at > 0) add_piece(path, *step, at, end, passed);
            if (last) break;
            at = end;
        }
    }

    VectorPoint place(const StripStep& step, double at, double passed) const {
        const ScreenSegment& segment = pieces_.screen[step.screen];
        const double share = (at - step.start) / segment.length;
        VectorPoint point = step.reversed ? between(segment.q, segment.p, share)
                                          : between(segment.p, segment.q, share);
        point.arc = strip_.start_arc + passed + at;
        return point;
    }

    void add_piece(VectorPath& path, const StripStep& step, double from, double to,
                   double passed) const {
        if (!(pieces_.screen[step.screen].length > 0)) return;
        if (path.points.empty()) path.points.push_back(place(step, from, passed));
        VectorPiece piece{.point = static_cast<std::uint32_t>(path.points.size() - 1),
                          .segment = step.segment};
        if (step.segment < lines_.sources.size()) piece.source = lines_.sources[step.segment];
        if (step.reversed) std::swap(piece.source.from, piece.source.to);
        path.pieces.push_back(piece);
        path.points.push_back(place(step, to, passed));
    }

    const LineSet& lines_;
    const Pieces& pieces_;
    const Strip& strip_;
};

} // namespace

std::vector<VectorPath> chain_strips(const LineSet& lines, const Pieces& pieces,
                                     const std::vector<Strip>& strips) {
    std::vector<VectorPath> paths;
    for (const Strip& strip : strips) {
        const PathMaker maker{lines, pieces, strip};
        for (const Stroke& stroke : across_seam(strip)) {
            VectorPath path = maker.make(stroke);
            if (path.points.size() > 1) paths.push_back(std::move(path));
        }
    }
    return paths;
}

} // namespace lineatlas
