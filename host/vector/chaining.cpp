#include "chaining.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// Places along a strip are the same within this, pixels: rounding.
constexpr double rounding = 1e-6;

/// The strokes of a closed strip, with those that meet at its seam joined to one. That one goes on
/// beyond the strip's length.
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
    PathMaker(const LineSet& lines, const Pieces& pieces, const Strip& strip, const PathPens* pens)
        : lines_(lines), pieces_(pieces), strip_(strip), pens_(pens) {}

    /// Adds the polylines of a stroke, one for each part with another pen.
    void add(const Stroke& stroke, std::vector<VectorPath>& paths) const {
        const std::vector<Stretch> parts =
            pens_ != nullptr ? parts_by_pen(stroke) : std::vector<Stretch>{};
        if (parts.size() < 2) {
            add_whole(stroke, 0.5 * (stroke.from + stroke.to), paths);
            return;
        }
        for (const Stretch part : parts) {
            Stroke own = stroke;
            own.from = part.from;
            own.to = part.to;
            add_whole(own, middle_of(part), paths);
        }
    }

  private:
    static double middle_of(Stretch part) { return 0.5 * (part.from + part.to); }

    /// Whether a stroke is the whole of a closed strip.
    bool goes_round(const Stroke& stroke) const {
        return strip_.closed && stroke.length() > strip_.length - same_place;
    }

    /// How lines are drawn at a place of the strip.
    struct Look {
        std::uint32_t pen = 0;
        bool outline = false;
        bool operator==(const Look&) const = default;
    };

    /// A place of the strip in the first lap of a closed one.
    double in_first_lap(double place) const {
        return strip_.closed ? place - std::floor(place / strip_.length) * strip_.length : place;
    }

    Look look_at(double place, bool visible) const {
        if (pens_ == nullptr) return {};
        const double at = in_first_lap(place);
        const auto after = std::ranges::upper_bound(strip_.steps, at, {}, &StripStep::start);
        const StripStep& step = after == strip_.steps.begin() ? *after : *std::prev(after);
        const bool beside = std::ranges::any_of(
            strip_.outlines, [&](Stretch one) { return one.from <= at && at <= one.to; });
        const LinePens::OfClass pens =
            pens_->pens.of_class[pens_->classes.of_segment[step.segment]];
        if (!visible) return {.pen = pens.hidden, .outline = false};
        const bool outline = beside && pens_->pens.tell_outlines() && can_be_outline(strip_.kind);
        return {.pen = outline ? pens.outline : pens.inner, .outline = outline};
    }

    /// The parts of a stroke between changes of its look.
    std::vector<Stretch> parts_by_pen(const Stroke& stroke) const {
        std::vector<double> places{stroke.from, stroke.to};
        const auto add = [&](double place) {
            const auto inside = [&](double at) { return at > stroke.from && at < stroke.to; };
            if (inside(place)) places.push_back(place);
            if (strip_.closed && inside(place - strip_.length))
                places.push_back(place - strip_.length);
        };
        for (const StripStep& step : strip_.steps) add(step.start);
        for (const Stretch& stretch : strip_.outlines) {
            add(stretch.from);
            add(stretch.to);
        }
        std::ranges::sort(places);
        std::vector<Stretch> parts;
        Look before;
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            if (places[i + 1] - places[i] <= rounding) continue;
            const Look look = look_at(0.5 * (places[i] + places[i + 1]), stroke.visible);
            if (parts.empty() || !(look == before))
                parts.push_back({places[i], places[i + 1]});
            else
                parts.back().to = places[i + 1];
            before = look;
        }
        if (parts.empty()) return parts;
        parts.front().from = stroke.from;
        parts.back().to = stroke.to;
        if (goes_round(stroke) && parts.size() > 2 &&
            look_at(middle_of(parts.front()), stroke.visible) == before) {
            parts.back().to += parts.front().to - parts.front().from;
            parts.erase(parts.begin());
        }
        return parts;
    }

    void add_whole(const Stroke& stroke, double middle, std::vector<VectorPath>& paths) const {
        VectorPath path = make(stroke);
        if (path.points.size() < 2) return;
        const Look look = look_at(middle, stroke.visible);
        path.pen = look.pen;
        path.outline = look.outline;
        paths.push_back(std::move(path));
    }

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
        path.closed = goes_round(stroke);
        const double to = path.closed ? stroke.from + strip_.length : stroke.to;
        for (double lap = std::floor(stroke.from / strip_.length); lap * strip_.length < to;
             ++lap) {
            const double passed = lap * strip_.length;
            add_part(path, std::max(stroke.from - passed, 0.0),
                     std::min(to - passed, strip_.length), passed);
        }
        // Both ends are the same bit by bit, in spite of rounding.
        if (path.closed) path.points.back().at = path.points.front().at;
        return path;
    }

    /// Adds the part between two places of one lap. Beyond the strip's ends it goes straight on.
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
        path.points.push_back(place(step, to, passed));
        if (is_contour(lines_, step.segment) || runs_through(step.segment)) {
            piece.over_start = over(step.segment, path.points.end()[-2].world);
            piece.over_end = over(step.segment, path.points.back().world);
        }
        path.pieces.push_back(piece);
    }

    /// Whether a segment is a ridge or a valley. Other lines within a triangle have edges or a
    /// second triangle.
    bool runs_through(std::uint32_t segment) const {
        const std::uint32_t kind = lines_.segments[segment].tag & LA_TAG_KIND_MASK;
        return (1U << kind & LA_KINDS_OF_SHAPE) != 0;
    }

    /// The place of its triangle that a point of a contour, ridge or valley lies over, as shares of
    /// the corners.
    glm::vec3 over(std::uint32_t segment, glm::dvec3 point) const {
        const glm::uvec3 triangle = lines_.triangles[lines_.segments[segment].face_a];
        const auto corner = [&](int k) { return glm::dvec3{lines_.vertices[triangle[k]]}; };
        const glm::dvec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        glm::dvec3 shares{0};
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 a = corner((k + 1) % 3), b = corner((k + 2) % 3);
            // The surface bulges beyond the triangle's sides.
            shares[k] = std::max(glm::dot(glm::cross(a - point, b - point), normal), 0.0);
        }
        const double sum = shares.x + shares.y + shares.z;
        return glm::vec3{sum > 0 ? shares / sum : glm::dvec3{1.0 / 3}};
    }

    const LineSet& lines_;
    const Pieces& pieces_;
    const Strip& strip_;
    const PathPens* pens_;
};

} // namespace

std::vector<VectorPath> chain_strips(const LineSet& lines, const Pieces& pieces,
                                     const std::vector<Strip>& strips, const PathPens* pens) {
    std::vector<VectorPath> paths;
    for (const Strip& strip : strips) {
        const PathMaker maker{lines, pieces, strip, pens};
        for (const Stroke& stroke : across_seam(strip)) maker.add(stroke, paths);
    }
    return paths;
}

} // namespace lineatlas
