#include "clip_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "circle_crossings.hpp"
#include "paths.hpp"
#include "pieces.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t no_curve = VectorCurve::none;
/// Places that are closer along a path are one, doubled by rounding; shares of a piece.
constexpr double shortest = 1e-9;

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
    ParametricCurve(const VectorPath& path, std::uint32_t number)
        : path_(path), curve_(path.curves[number]), number_(number) {}

    glm::dvec2 at(double parameter) const {
        return curve_.cubic ? point_of(*curve_.cubic, start(), end(), parameter)
                            : curve_.arc.at(parameter);
    }

    /// Adds the places where the curve crosses the circle.
    void add_crossings(const Circle& circle, std::vector<PathPlace>& places) const {
        const std::vector<double> found = curve_.cubic
                                              ? crossings(*curve_.cubic, start(), end(), circle)
                                              : crossings(curve_.arc, circle);
        if (found.empty()) return;
        const std::vector<double> of_points = parameters();
        for (const double parameter : found) places.push_back(place(parameter, of_points));
    }

    /// The point at a place along the path.
    glm::dvec2 at_place(double along) const {
        const std::vector<double> of_points = parameters();
        const auto i =
            std::min(static_cast<std::size_t>(along - curve_.first), of_points.size() - 2);
        const double share = along - curve_.first - static_cast<double>(i);
        return at(std::lerp(of_points[i], of_points[i + 1], share));
    }

  private:
    glm::dvec2 start() const { return path_.points[curve_.first].at; }
    glm::dvec2 end() const { return path_.points[curve_.last].at; }
    double from() const { return curve_.cubic ? 0 : curve_.arc.from; }
    double to() const { return curve_.cubic ? 1 : curve_.arc.from + curve_.arc.sweep; }

    /// The parameters of the path's points along the curve.
    std::vector<double> parameters() const {
        std::vector<double> result{from()};
        for (std::uint32_t i = curve_.first + 1; i < curve_.last; ++i)
            result.push_back(curve_.cubic ? nearest_share(path_.points[i].at)
                                          : angle_of(path_.points[i].at));
        result.push_back(to());
        return result;
    }

    /// The angle of a point of the arc between its ends.
    double angle_of(glm::dvec2 point) const {
        const VectorArc& arc = curve_.arc;
        const glm::dvec2 offset = point - arc.center;
        const double angle = std::atan2(glm::dot(offset, {-arc.major.y, arc.major.x}) / arc.ratio,
                                        glm::dot(offset, arc.major));
        const double around = std::copysign(2 * std::numbers::pi, arc.sweep);
        const double turns = (angle - arc.from) / around;
        return arc.from + (turns - std::floor(turns)) * around;
    }

    /// The share of the cubic at which a point lies.
    double nearest_share(glm::dvec2 point) const {
        constexpr int steps = 512;
        const auto distance = [&](double share) { return glm::distance(at(share), point); };
        int best = 0;
        for (int i = 1; i <= steps; ++i)
            if (distance(1.0 * i / steps) < distance(1.0 * best / steps)) best = i;
        double low = std::max(best - 1.0, 0.0) / steps,
               high = std::min(best + 1.0, 1.0 * steps) / steps;
        for (int i = 0; i < 60; ++i) {
            const double third = (high - low) / 3;
            const bool lower = distance(low + third) < distance(high - third);
            (lower ? high : low) += lower ? -third : third;
        }
        return 0.5 * (low + high);
    }

    PathPlace place(double parameter, const std::vector<double>& of_points) const {
        const bool falls = to() < from();
        std::size_t i = 0;
        while (i + 2 < of_points.size() &&
               (falls ? parameter < of_points[i + 1] : parameter > of_points[i + 1]))
            ++i;
        const double way = of_points[i + 1] - of_points[i];
        const double share = way == 0 ? 0 : (parameter - of_points[i]) / way;
        return {.along = curve_.first + static_cast<double>(i) + std::clamp(share, 0.0, 1.0),
                .at = at(parameter),
                .curve = number_,
                .parameter = parameter};
    }

    const VectorPath& path_;
    const VectorCurve& curve_;
    std::uint32_t number_;
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
        if (!(share > -shortest) || !(share < 1 + shortest)) continue;
        const double rounded =
            std::abs(share - std::round(share)) < shortest ? std::round(share) : share;
        places.push_back({.along = point + rounded, .at = from + rounded * way});
    }
}

/// Adds a point of the path if it lies on the circle: rounding may put the crossing beyond the end
/// of either piece that meets there.
void add_if_on(const Circle& circle, const VectorPath& path, std::uint32_t point,
               std::vector<PathPlace>& places) {
    const glm::dvec2 at = path.points[point].at;
    if (std::abs(circle.beyond(at)) <= circle.rounding())
        places.push_back({.along = static_cast<double>(point), .at = at});
}

/// Where the path crosses the circle, and perhaps where it touches it, in any order.
std::vector<PathPlace> crossings_of(const Circle& circle, const VectorPath& path) {
    std::vector<PathPlace> places;
    std::uint32_t point = 0;
    const auto add_straight = [&](std::uint32_t end) {
        for (; point < end; ++point) {
            add_if_on(circle, path, point, places);
            add_crossings(circle, path, point, places);
        }
        add_if_on(circle, path, end, places);
    };
    for (std::uint32_t i = 0; i < path.curves.size(); ++i) {
        add_straight(path.curves[i].first);
        ParametricCurve{path, i}.add_crossings(circle, places);
        point = path.curves[i].last;
    }
    add_straight(static_cast<std::uint32_t>(path.points.size() - 1));
    return places;
}

glm::dvec2 point_at(const VectorPath& path, double along) {
    for (std::uint32_t i = 0; i < path.curves.size(); ++i)
        if (along > path.curves[i].first && along < path.curves[i].last)
            return ParametricCurve{path, i}.at_place(along);
    const auto i = static_cast<std::size_t>(along);
    return glm::mix(path.points[i].at, path.points[i + 1].at, along - static_cast<double>(i));
}

/// A part of a path between two places.
struct PathInterval {
    PathPlace from, to;
};

/// Whether an interval that does not cross the circle lies within it. Of some points the farthest
/// from the circle decides, because the path may touch the circle at another one.
bool lies_within(const Circle& circle, const VectorPath& path, const PathInterval& interval) {
    double farthest = 0;
    for (const double share : {0.25, 0.5, 0.75}) {
        const double along = std::lerp(interval.from.along, interval.to.along, share);
        const double beyond = circle.beyond(point_at(path, along));
        if (std::abs(beyond) > std::abs(farthest)) farthest = beyond;
    }
    return farthest <= circle.rounding();
}

/// The parts of a path within the circle, in order. Parts that meet are one.
std::vector<PathInterval> intervals_within(const Circle& circle, const VectorPath& path,
                                           std::vector<PathPlace> places) {
    const auto end = static_cast<double>(path.points.size() - 1);
    std::erase_if(places, [&](const PathPlace& place) {
        return place.along < shortest || place.along > end - shortest;
    });
    places.push_back({.along = 0, .at = path.points.front().at});
    places.push_back({.along = end, .at = path.points.back().at});
    std::ranges::sort(places, {}, &PathPlace::along);
    std::vector<PathInterval> within;
    bool goes_on = false;
    PathPlace from = places.front();
    for (const PathPlace& to : places) {
        if (to.along - from.along < shortest) continue;
        const PathInterval interval{from, to};
        const bool inside = lies_within(circle, path, interval);
        if (inside && goes_on)
            within.back().to = to;
        else if (inside)
            within.push_back(interval);
        goes_on = inside;
        from = to;
    }
    return within;
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
        VectorPoint point = between(whole_.points[i], whole_.points[i + 1], place.along - i);
        point.at = place.at;
        return point;
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

/// Adds the parts of a path that lie in the circle.
void add_parts(const VectorPath& path, const Circle& circle, std::vector<VectorPath>& parts) {
    const auto end = static_cast<double>(path.points.size() - 1);
    std::vector<PathPlace> crossings = crossings_of(circle, path);
    if (crossings.empty()) {
        if (circle.beyond(path.points.front().at) < 0) parts.push_back(path);
        return;
    }
    const std::vector<PathInterval> within = intervals_within(circle, path, std::move(crossings));
    if (within.empty()) return;
    const bool from_start = within.front().from.along == 0, to_end = within.back().to.along == end;
    if (within.size() == 1 && from_start && to_end) {
        parts.push_back(path);
        return;
    }
    std::vector<VectorPath> own;
    for (const PathInterval& interval : within)
        own.push_back(PathPart{path, interval.from, interval.to}.take());
    if (path.closed && from_start && to_end) {
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
