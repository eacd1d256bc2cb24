#include "arc_fitting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "circle_fitting.hpp"
#include "core/plane_vectors.hpp"

namespace lineatlas {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double tolerance = 0.02; ///< pixels from the circle
constexpr std::size_t fewest_points = 5;
constexpr double least_sweep = 30 * degree;

using Points = std::span<const glm::dvec2>;

/// The circle through points; nothing if its radius is within the tolerance.
std::optional<Circle> circle_of(Points points) {
    const std::optional<Circle> circle = fit_circle(points);
    return circle && circle->radius > tolerance ? circle : std::nullopt;
}

/// The angle that points go round the circle; nothing unless they lie on it one after the other.
std::optional<double> sweep_on(const Circle& circle, Points points) {
    double sweep = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!(std::abs(circle.distance(points[i])) <= tolerance)) return std::nullopt;
        if (i == 0) continue;
        const double step = circle.angle(points[i - 1], points[i]);
        if (!circle.is_told_by(std::abs(step))) return std::nullopt;
        if (step == 0 || (sweep != 0 && (step > 0) != (sweep > 0))) return std::nullopt;
        sweep += step;
    }
    return sweep;
}

struct FoundArc {
    Circle circle;
    glm::dvec2 start, end;
    double sweep;
};

class ArcFinder {
  public:
    explicit ArcFinder(const Outline& outline) : closed_(outline.closed) {
        for (const OutlinePoint& point : outline.points) points_.push_back(point.at);
        // The piece back to the first point counts like all others.
        if (closed_) points_.push_back(points_.front());
    }

    std::optional<Outline> whole_circle() const {
        if (!closed_ || points_.size() <= fewest_points) return std::nullopt;
        const std::optional<Circle> circle = circle_of(Points{points_}.first(points_.size() - 1));
        const auto sweep = circle ? sweep_on(*circle, points_) : std::nullopt;
        if (!sweep || std::abs(std::abs(*sweep) - 2 * std::numbers::pi) > 0.01) return std::nullopt;
        const glm::dvec2 start = circle->nearest(points_.front());
        const double bulge = *sweep > 0 ? 1 : -1;
        return Outline{.points = {{start, bulge}, {2.0 * circle->center - start, bulge}},
                       .closed = true};
    }

    Outline run() {
        std::vector<Piece> pieces = find_pieces();
        const auto arc = std::ranges::find_if(pieces, &Piece::is_arc);
        if (arc == pieces.end()) return outline_of(pieces);
        if (closed_) { // a loop that starts within an arc would have it in two
            points_.pop_back();
            std::rotate(points_.begin(),
                        points_.begin() + static_cast<std::ptrdiff_t>(arc->last % points_.size()),
                        points_.end());
            points_.push_back(points_.front());
            pieces = find_pieces();
        }
        drop_parts_of_other_curves(pieces);
        return outline_of(pieces);
    }

  private:
    /// An arc, or the straight way from one point to the next.
    struct Piece {
        std::size_t first, last;
        std::optional<FoundArc> arc;

        bool is_arc() const { return arc.has_value(); }
    };

    std::vector<Piece> find_pieces() const {
        std::vector<Piece> pieces;
        for (std::size_t at = 0; at + 1 < points_.size(); at = pieces.back().last) {
            std::size_t end = at + 1;
            std::optional<FoundArc> arc = longest_arc(at, end);
            pieces.push_back({at, end, arc});
        }
        return pieces;
    }

    Outline outline_of(const std::vector<Piece>& pieces) const {
        Outline outline{.points = {}, .closed = closed_};
        OutlinePoint here{points_.front()};
        for (const Piece& piece : pieces) {
            if (piece.arc) {
                if (piece.first == 0) here.at = piece.arc->start;
                here.bulge = std::tan(0.25 * piece.arc->sweep);
            }
            outline.points.push_back(here);
            here = {piece.arc ? piece.arc->end : points_[piece.last]};
        }
        if (!closed_) outline.points.push_back(here);
        return outline;
    }

    /// The angle by which the way turns at the end of a piece, towards the next one.
    double turn_between(const Piece& piece, const Piece& next) const {
        const glm::dvec2 a = points_[piece.last] - points_[piece.last - 1];
        const glm::dvec2 b = points_[next.first + 1] - points_[next.first];
        return angle_between(a, b);
    }

    /// A part of an ellipse near its end resembles an arc, too. So an arc is dropped if the path
    /// bends on beyond it in steps as small: all of that is a curve of another kind.
    void drop_parts_of_other_curves(std::vector<Piece>& pieces) const {
        const std::size_t count = pieces.size();
        const auto bends_on = [&](std::size_t arc, bool forwards) {
            const double step =
                pieces[arc].arc->sweep / static_cast<double>(pieces[arc].last - pieces[arc].first);
            std::size_t at = arc;
            for (int i = 0; i < 2; ++i) {
                const bool ends = forwards ? at + 1 == count : at == 0;
                if (ends && !closed_) return false;
                const std::size_t next = (at + (forwards ? 1 : count - 1)) % count;
                if (pieces[next].is_arc()) return false;
                const double turn = forwards ? turn_between(pieces[at], pieces[next])
                                             : turn_between(pieces[next], pieces[at]);
                if (!(turn / step > 0.3) || std::abs(turn) > Circle::largest_step) return false;
                at = next;
            }
            return true;
        };
        std::vector<Piece> kept;
        for (std::size_t i = 0; i < count; ++i) {
            if (!pieces[i].is_arc() || !(bends_on(i, true) || bends_on(i, false))) {
                kept.push_back(pieces[i]);
                continue;
            }
            for (std::size_t at = pieces[i].first; at < pieces[i].last; ++at)
                kept.push_back({at, at + 1, std::nullopt});
        }
        pieces = std::move(kept);
    }

    bool may_be_cut(std::size_t point) const {
        return !closed_ && (point == 0 || point + 1 == points_.size());
    }

    /// The arc through the points from `first` to `last`.
    std::optional<FoundArc> arc_through(std::size_t first, std::size_t last) const {
        const std::size_t cut_start = may_be_cut(first) ? 1 : 0;
        const std::size_t cut_end = may_be_cut(last) ? 1 : 0;
        const std::size_t count = last - first + 1 - cut_start - cut_end;
        if (count < fewest_points - 1) return std::nullopt;
        const Points sure = Points{points_}.subspan(first + cut_start, count);
        const std::optional<Circle> circle = circle_of(sure);
        const auto sweep = circle ? sweep_on(*circle, sure) : std::nullopt;
        if (!sweep) return std::nullopt;
        double widest = 0;
        for (std::size_t i = 1; i < sure.size(); ++i)
            widest = std::max(widest, std::abs(circle->angle(sure[i - 1], sure[i])));
        FoundArc arc{*circle, points_[first], points_[last], *sweep};
        const auto take_end = [&](glm::dvec2 inner, glm::dvec2& end, double direction) {
            const double inside = -circle->distance(end);
            const double step = direction * circle->angle(inner, end);
            if (inside < -tolerance || inside > circle->sagitta(widest) + tolerance) return false;
            if (!(step * arc.sweep > 0) || std::abs(step) > widest * 1.01) return false;
            end = circle->nearest(end);
            arc.sweep += step;
            return true;
        };
        if (cut_start != 0 && !take_end(sure.front(), arc.start, -1)) return std::nullopt;
        if (cut_end != 0 && !take_end(sure.back(), arc.end, 1)) return std::nullopt;
        if (std::abs(arc.sweep) > 1.99 * std::numbers::pi) return std::nullopt; // comes round
        return arc;
    }

    /// The longest arc that starts at `first`; `end` becomes its last point.
    std::optional<FoundArc> longest_arc(std::size_t first, std::size_t& end) const {
        const std::size_t last = points_.size() - 1;
        std::optional<FoundArc> found;
        for (std::size_t i = first + fewest_points - 1; i <= last; ++i) {
            if (!turns_one_way(Points{points_}.subspan(first, i - first + 1))) break;
            const std::optional<FoundArc> arc = arc_through(first, i);
            if (!arc) break;
            if (std::abs(arc->sweep) < least_sweep) continue;
            found = arc;
            end = i;
        }
        return found;
    }

    /// False for a run whose last three points turn back: a cheap test that it is no arc.
    static bool turns_one_way(Points run) {
        const auto turn = [&](std::size_t i) {
            const glm::dvec2 a = run[i] - run[i - 1];
            const glm::dvec2 b = run[i + 1] - run[i];
            return cross(a, b);
        };
        const std::size_t last = run.size() - 2;
        return turn(1) * turn(last) > 0;
    }

    std::vector<glm::dvec2> points_;
    bool closed_;
};

} // namespace

Outline fit_arcs(const Outline& outline) {
    if (outline.points.size() < fewest_points) return outline;
    ArcFinder finder{outline};
    if (std::optional<Outline> circle = finder.whole_circle()) return *circle;
    return finder.run();
}

} // namespace lineatlas
