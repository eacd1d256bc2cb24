#include "clip_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

struct Circle {
    glm::dvec2 center;
    double radius;

    /// Below 0 within it.
    double beyond(glm::dvec2 at) const { return glm::distance(at, center) - radius; }
    bool has(glm::dvec2 at) const { return beyond(at) < 0; }
};

constexpr std::uint32_t no_curve = VectorCurve::none;

/// A place along a path.
struct PathPlace {
    double along = 0;               ///< number of the point before it, and the share of the way on
    glm::dvec2 at{0};               ///< pixels
    std::uint32_t curve = no_curve; ///< that it lies on
    double parameter = 0;           ///< of the curve: an angle of an arc, a share of a cubic

    std::uint32_t point() const { return static_cast<std::uint32_t>(along); }
};

/// A curve of a path, by its parameter.
class ParametricCurve {
  public:
    ParametricCurve(const VectorPath& path, const VectorCurve& curve)
        : curve_(curve), start_(path.points[curve.first].at), end_(path.points[curve.last].at) {
        for (std::uint32_t i = curve.first; i <= curve.last; ++i)
            parameters_.push_back(i == curve.first  ? from()
                                  : i == curve.last ? to()
                                                    : nearest(path.points[i].at));
    }

    double from() const { return curve_.cubic ? 0 : curve_.arc.from; }
    double to() const { return curve_.cubic ? 1 : curve_.arc.from + curve_.arc.sweep; }

    glm::dvec2 at(double parameter) const {
        if (!curve_.cubic) return curve_.arc.at(parameter);
        const double t = parameter, s = 1 - t;
        return s * s * s * start_ + 3 * s * s * t * curve_.cubic->first_control +
               3 * s * t * t * curve_.cubic->last_control + t * t * t * end_;
    }

    /// Where the curve enters the circle or leaves it, in order.
    std::vector<PathPlace> crossings(const Circle& circle, std::uint32_t number) const {
        std::vector<PathPlace> found;
        double before = from();
        for (int i = 1; i <= steps; ++i) {
            const double next = step(i);
            if (circle.has(at(before)) != circle.has(at(next)))
                found.push_back(place(crossing(circle, before, next), number));
            before = next;
        }
        return found;
    }

  private:
    static constexpr int steps = 512;

    double step(int i) const { return from() + (to() - from()) * i / steps; }

    double crossing(const Circle& circle, double low, double high) const {
        const bool starts_within = circle.has(at(low));
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (circle.has(at(middle)) == starts_within ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    /// The parameter of a point that lies on the curve.
    double nearest(glm::dvec2 point) const {
        int best = 0;
        for (int i = 1; i <= steps; ++i)
            if (glm::distance(at(step(i)), point) < glm::distance(at(step(best)), point)) best = i;
        double low = step(std::max(best - 1, 0)), high = step(std::min(best + 1, steps));
        for (int i = 0; i < 60; ++i) {
            const double third = (high - low) / 3;
            const bool lower =
                glm::distance(at(low + third), point) < glm::distance(at(high - third), point);
            (lower ? high : low) += lower ? -third : third;
        }
        return 0.5 * (low + high);
    }

    PathPlace place(double parameter, std::uint32_t number) const {
        const bool falls = to() < from();
        std::size_t i = 0;
        while (i + 2 < parameters_.size() &&
               (falls ? parameter < parameters_[i + 1] : parameter > parameters_[i + 1]))
            ++i;
        const double way = parameters_[i + 1] - parameters_[i];
        const double share = way == 0 ? 0 : (parameter - parameters_[i]) / way;
        return {.along = curve_.first + static_cast<double>(i) + std::clamp(share, 0.0, 1.0),
                .at = at(parameter),
                .curve = number,
                .parameter = parameter};
    }

    const VectorCurve& curve_;
    glm::dvec2 start_, end_;
    std::vector<double> parameters_; ///< of the points along it
};

/// Adds the places where a straight piece crosses the circle.
void add_crossings(const Circle& circle, const VectorPath& path, std::uint32_t point,
                   std::vector<PathPlace>& places) {
    const glm::dvec2 from = path.points[point].at, way = path.points[point + 1].at - from;
    const glm::dvec2 to_start = from - circle.center;
    const double square = glm::dot(way, way), half = glm::dot(way, to_start);
    const double rest = glm::dot(to_start, to_start) - circle.radius * circle.radius;
    const double inner = half * half - square * rest;
    if (!(square > 0) || !(inner > 0)) return;
    for (const double sign : {-1.0, 1.0}) {
        const double share = (sign * std::sqrt(inner) - half) / square;
        if (share > 0 && share <= 1)
            places.push_back({.along = point + share, .at = from + share * way});
    }
}

std::vector<PathPlace> crossings_of(const Circle& circle, const VectorPath& path) {
    std::vector<PathPlace> places;
    const auto count = static_cast<std::uint32_t>(path.points.size());
    std::uint32_t point = 0;
    const auto add_straight = [&](std::uint32_t end) {
        for (; point < end; ++point) add_crossings(circle, path, point, places);
    };
    for (std::uint32_t i = 0; i < path.curves.size(); ++i) {
        add_straight(path.curves[i].first);
        std::ranges::copy(ParametricCurve{path, path.curves[i]}.crossings(circle, i),
                          std::back_inserter(places));
        point = path.curves[i].last;
    }
    add_straight(count - 1);
    return places;
}

/// The part of a cubic from one parameter to another (de Casteljau, by blossoms).
VectorCubic part_of(const VectorCubic& cubic, glm::dvec2 start, glm::dvec2 end, double from,
                    double to) {
    const auto blossom = [&](double a, double b, double c) {
        const glm::dvec2 ab = glm::mix(start, cubic.first_control, a);
        const glm::dvec2 bc = glm::mix(cubic.first_control, cubic.last_control, a);
        const glm::dvec2 cd = glm::mix(cubic.last_control, end, a);
        return glm::mix(glm::mix(ab, bc, b), glm::mix(bc, cd, b), c);
    };
    return {blossom(from, from, to), blossom(from, to, to)};
}

/// The part of a path between two places.
class PathPart {
  public:
    PathPart(const VectorPath& whole, const PathPlace& from, const PathPlace& to)
        : whole_(whole), from_(from), to_(to), part_(whole) {
        part_.closed = false;
        part_.points.clear();
        part_.pieces.clear();
        part_.curves.clear();
        add_points();
        for (const VectorPiece& piece : whole.pieces) add(piece);
        for (std::uint32_t i = 0; i < whole.curves.size(); ++i) add(i);
    }
    VectorPath take() { return std::move(part_); }

  private:
    VectorPoint point_at(const PathPlace& place) const {
        const auto last = static_cast<std::uint32_t>(whole_.points.size() - 1);
        const std::uint32_t i = std::min(place.point(), last - 1);
        const VectorPoint &a = whole_.points[i], &b = whole_.points[i + 1];
        const double share = place.along - i;
        return {.at = place.at,
                .depth = glm::mix(a.depth, b.depth, share),
                .inverse_w = glm::mix(a.inverse_w, b.inverse_w, share),
                .world = glm::mix(a.world, b.world, share),
                .arc = glm::mix(a.arc, b.arc, share)};
    }

    void add_points() {
        part_.points.push_back(point_at(from_));
        for (std::uint32_t i = from_.point() + 1; i < to_.along; ++i)
            part_.points.push_back(whole_.points[i]);
        part_.points.push_back(point_at(to_));
    }

    void add(const VectorPiece& piece) {
        // The piece within the part, and the ends of its straight way, in places along the path.
        const double first = std::max(from_.along, static_cast<double>(piece.point));
        const double last = std::min(to_.along, piece.point + 1.0);
        const double starts = piece.point + static_cast<double>(piece.from);
        const double ends = piece.point + static_cast<double>(piece.to);
        const double from = std::max(starts, first), to = std::min(ends, last);
        if (!(from < to)) return;
        const auto share = [](double at, double low, double high) {
            return static_cast<float>((at - low) / (high - low));
        };
        VectorPiece own = piece;
        own.point = piece.point - from_.point();
        own.from = share(from, first, last);
        own.to = share(to, first, last);
        own.over_start = glm::mix(piece.over_start, piece.over_end, share(from, starts, ends));
        own.over_end = glm::mix(piece.over_start, piece.over_end, share(to, starts, ends));
        part_.pieces.push_back(own);
    }

    void add(std::uint32_t number) {
        const VectorCurve& curve = whole_.curves[number];
        if (curve.last <= from_.along || curve.first >= to_.along) return;
        const bool starts = from_.curve == number, ends = to_.curve == number;
        const auto last_point = static_cast<std::uint32_t>(part_.points.size() - 1);
        VectorCurve own = curve;
        own.first = starts ? 0 : curve.first - from_.point();
        own.last = ends ? last_point : curve.last - from_.point();
        if (curve.cubic) {
            own.cubic =
                part_of(*curve.cubic, whole_.points[curve.first].at, whole_.points[curve.last].at,
                        starts ? from_.parameter : 0, ends ? to_.parameter : 1);
        } else {
            const double end = ends ? to_.parameter : curve.arc.from + curve.arc.sweep;
            if (starts) own.arc.from = from_.parameter;
            own.arc.sweep = end - own.arc.from;
        }
        part_.curves.push_back(own);
    }

    const VectorPath& whole_;
    PathPlace from_, to_;
    VectorPath part_;
};

bool goes_on(const VectorArc& a, const VectorArc& b) {
    return a.center == b.center && a.major == b.major && a.ratio == b.ratio &&
           std::signbit(a.sweep) == std::signbit(b.sweep);
}

/// Adds to the end of a path what begins there.
void append(VectorPath& path, const VectorPath& more) {
    const auto shift = static_cast<std::uint32_t>(path.points.size() - 1);
    path.points.insert(path.points.end(), more.points.begin() + 1, more.points.end());
    for (VectorPiece piece : more.pieces) {
        piece.point += shift;
        path.pieces.push_back(piece);
    }
    for (VectorCurve curve : more.curves) {
        curve.first += shift;
        curve.last += shift;
        VectorCurve* before = path.curves.empty() ? nullptr : &path.curves.back();
        if (before != nullptr && before->last == curve.first && !before->cubic && !curve.cubic &&
            goes_on(before->arc, curve.arc)) {
            before->last = curve.last;
            before->arc.sweep += curve.arc.sweep;
        } else {
            path.curves.push_back(curve);
        }
    }
}

/// Adds the parts of a path that lie in the circle.
void add_parts(const VectorPath& path, const Circle& circle, std::vector<VectorPath>& parts) {
    const std::vector<PathPlace> crossings = crossings_of(circle, path);
    const bool starts_within = circle.has(path.points.front().at);
    if (crossings.empty()) {
        if (starts_within) parts.push_back(path);
        return;
    }
    std::vector<PathPlace> ends = crossings;
    if (starts_within) ends.insert(ends.begin(), {.at = path.points.front().at});
    if (ends.size() % 2 == 1)
        ends.push_back(
            {.along = static_cast<double>(path.points.size() - 1), .at = path.points.back().at});
    std::vector<VectorPath> own;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        if (ends[i].along < ends[i + 1].along)
            own.push_back(PathPart{path, ends[i], ends[i + 1]}.take());
    const bool joins =
        path.closed && starts_within && own.size() > 1 && ends.size() > crossings.size() + 1;
    if (joins) {
        append(own.back(), own.front());
        own.erase(own.begin());
    }
    std::ranges::move(own, std::back_inserter(parts));
}

/// The area of a ring on one side of a line (Sutherland & Hodgman 1974): where
/// dot(normal, point) <= reach.
std::vector<glm::dvec2> beside_line(const std::vector<glm::dvec2>& ring, glm::dvec2 normal,
                                    double reach) {
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        const double at_a = glm::dot(normal, a) - reach, at_b = glm::dot(normal, b) - reach;
        if (at_a <= 0) kept.push_back(a);
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
            kept.push_back(glm::mix(a, b, at_a / (at_a - at_b)));
    }
    return kept;
}

void clip(VectorFill& fill, const Circle& circle) {
    constexpr int sides = 720;
    for (std::vector<glm::dvec2>& ring : fill.rings) {
        for (int i = 0; i < sides && !ring.empty(); ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
            const glm::dvec2 normal{std::cos(angle), std::sin(angle)};
            const double reach = glm::dot(normal, circle.center) +
                                 circle.radius * std::cos(std::numbers::pi / sides);
            ring = beside_line(ring, normal, reach);
        }
    }
    std::erase_if(fill.rings, [](const auto& ring) { return ring.size() < 3; });
}

} // namespace

void clip_to_circle(VectorDrawing& drawing, glm::dvec2 center, double radius) {
    const Circle circle{center, radius};
    std::vector<VectorPath> parts;
    for (const VectorPath& path : drawing.paths) add_parts(path, circle, parts);
    drawing.paths = std::move(parts);
    for (VectorFill& fill : drawing.fills) clip(fill, circle);
    std::erase_if(drawing.fills, [](const VectorFill& fill) { return fill.rings.empty(); });
}

} // namespace lineatlas
