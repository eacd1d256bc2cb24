#include "drawing_errors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lineatlas/error.hpp"
#include "point_grid.hpp"

namespace lineatlas {
namespace {

constexpr double border = 2;      ///< pixels along the picture's edge that do not count
constexpr double rounding = 0.01; ///< of coordinates in a drawing, pixels
constexpr double drawn_step = 0.25;

constexpr double ink_missed_reach = 1;
constexpr double ink_false_reach = 1.5;
constexpr int dark_below = 128; ///< of 255

constexpr double own_reach = 0.3; ///< pixels between a piece and the segment that it shows
constexpr double sure_depth = 2.2;
constexpr double sure_distance = 1.5;

bool counts(const EdgeTruth& truth, glm::dvec2 at) {
    return at.x >= border && at.y >= border && at.x <= truth.size().x - border &&
           at.y <= truth.size().y - border;
}

bool is_inside(const EdgeTruth& truth, glm::dvec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x <= truth.size().x && at.y <= truth.size().y;
}

double sum(const std::vector<WrongPoint>& points) {
    double result = 0;
    for (const WrongPoint& point : points) result += double{point.pixels};
    return result;
}

/// The shares of a piece between which it may be in the picture; {1, 0} if it is not.
std::pair<double, double> shares_inside(const DrawnPiece& piece, glm::dvec2 size) {
    double first = 0, last = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double from = piece.from[axis], length = piece.to[axis] - from;
        const double at_zero = -from / length, at_size = (size[axis] - from) / length;
        if (length == 0 && (from < 0 || from > size[axis])) return {1, 0};
        if (length == 0) continue;
        first = std::max(first, std::min(at_zero, at_size));
        last = std::min(last, std::max(at_zero, at_size));
    }
    return {first, last};
}

std::vector<WrongPoint> sampled(const EdgeTruth& truth, std::span<const DrawnPiece> drawn) {
    std::vector<WrongPoint> points;
    for (const DrawnPiece& piece : drawn) {
        const double length = glm::distance(piece.from, piece.to);
        const double steps = std::max(1.0, std::ceil(length / drawn_step));
        // If a line goes far beyond the picture, only the part that may be in it is taken, and a
        // step more.
        const auto [first, last] = shares_inside(piece, truth.size());
        const double begin = std::max(0.0, std::floor(first * steps) - 1);
        const double end = std::min(steps, std::ceil(last * steps) + 1);
        for (double i = begin + 0.5; i < end; ++i) {
            const glm::dvec2 at = glm::mix(piece.from, piece.to, i / steps);
            if (is_inside(truth, at))
                points.push_back({glm::vec2{at}, static_cast<float>(length / steps)});
        }
    }
    return points;
}

std::vector<glm::vec2> places(const std::vector<WrongPoint>& points) {
    std::vector<glm::vec2> result;
    for (const WrongPoint& point : points) result.push_back(point.at);
    return result;
}

DrawingErrors compare_points(const EdgeTruth& truth, const std::vector<WrongPoint>& drawn,
                             double missed_reach, double false_reach) {
    std::vector<glm::vec2> allowed, bars;
    for (const EdgePoint& point : truth.points()) {
        if (point.visibility == Visibility::hidden) continue;
        for (const glm::vec2 at : {point.at, point.on_arc.value_or(point.at)}) {
            allowed.push_back(at);
            bars.push_back(0.5F * point.pixels * point.along);
            if (!point.on_arc) break;
        }
    }
    const PointGrid drawn_grid{places(drawn), truth.size()};
    const PointGrid allowed_grid{allowed, truth.size(), bars};
    DrawingErrors errors{.reach = missed_reach, .missed = {}, .false_drawn = {}};
    for (const EdgePoint& point : truth.points()) {
        const glm::dvec2 at{point.at};
        if (!counts(truth, at)) continue;
        if (point.visibility == Visibility::undecided) errors.undecided += double{point.pixels};
        if (point.visibility != Visibility::visible || !point.required) continue;
        errors.visible += double{point.pixels};
        const auto is_drawn = [&](glm::dvec2 place) {
            return drawn_grid.any_within(place, missed_reach + rounding);
        };
        if (!is_drawn(at) && !(point.on_arc && is_drawn(glm::dvec2{*point.on_arc})))
            errors.missed.push_back({point.at, point.pixels});
    }
    for (const WrongPoint& point : drawn) {
        const glm::dvec2 at{point.at};
        if (!counts(truth, at)) continue;
        errors.drawn += double{point.pixels};
        const double off = allowed_grid.distance(at, false_reach + rounding);
        if (std::isinf(off)) {
            errors.false_drawn.push_back(point);
        } else if (off > errors.off) {
            errors.off = off;
            errors.off_at = point.at;
        }
    }
    return errors;
}

bool is_dark(const Image& picture, std::size_t pixel) {
    const std::uint8_t* values =
        &picture.pixels[pixel * static_cast<std::size_t>(picture.channels)];
    if (picture.channels < 3) return values[0] < dark_below;
    return values[0] + values[1] + values[2] < 3 * dark_below;
}

} // namespace

double DrawingErrors::missed_pixels() const {
    return sum(missed);
}
double DrawingErrors::false_pixels() const {
    return sum(false_drawn);
}
double DrawingErrors::missed_share() const {
    return visible > 0 ? missed_pixels() / visible : 0;
}
double DrawingErrors::false_share() const {
    return visible > 0 ? false_pixels() / visible : 0;
}
double StrictErrors::surely_wrong_pixels() const {
    return sum(surely_wrong);
}

DrawingErrors compare_paths(const EdgeTruth& truth, std::span<const DrawnPiece> drawn,
                            double reach) {
    return compare_points(truth, sampled(truth, drawn), reach, reach);
}

DrawingErrors compare_ink(const EdgeTruth& truth, const Image& picture) {
    if (picture.size != truth.size())
        throw UsageError("compare_ink: the picture is not as large as the view");
    std::vector<WrongPoint> ink;
    for (int y = 0; y < picture.size.y; ++y) {
        for (int x = 0; x < picture.size.x; ++x) {
            const auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.x) +
                static_cast<std::size_t>(x);
            if (is_dark(picture, pixel)) ink.push_back({glm::vec2{x, y} + 0.5F, 1});
        }
    }
    return compare_points(truth, ink, ink_missed_reach, ink_false_reach);
}

StrictErrors compare_strictly(const EdgeTruth& truth, std::span<const DrawnPiece> drawn) {
    const EdgePoint* const first = truth.points().data();
    std::vector<bool> is_drawn(truth.points().size());
    StrictErrors errors;
    for (const DrawnPiece& piece : drawn) {
        const double length = glm::distance(piece.from, piece.to);
        if (piece.segment == DrawnPiece::unknown) {
            errors.unknown += length;
            continue;
        }
        if (length < 1e-6) continue;
        const glm::dvec2 along = (piece.to - piece.from) / length;
        for (const EdgePoint& point : truth.points_of(piece.segment)) {
            const glm::dvec2 offset = glm::dvec2{point.at} - piece.from;
            const double at = glm::dot(offset, along);
            const double beside = std::abs(offset.y * along.x - offset.x * along.y);
            if (at >= 0 && at <= length && beside < own_reach)
                is_drawn[static_cast<std::size_t>(&point - first)] = true;
        }
    }
    for (const EdgePoint& point : truth.points()) {
        if (!is_drawn[static_cast<std::size_t>(&point - first)]) continue;
        if (point.visibility == Visibility::undecided) continue;
        errors.decided += double{point.pixels};
        if (point.visibility == Visibility::visible) continue;
        errors.hidden += double{point.pixels};
        const auto blocker = truth.nearest_blocker(point);
        if (!blocker || blocker->distance < sure_depth) continue;
        const bool near_visible =
            std::ranges::any_of(truth.points_of(point.segment), [&](const EdgePoint& other) {
                return other.visibility != Visibility::hidden &&
                       glm::distance(glm::dvec2{other.at}, glm::dvec2{point.at}) <= sure_distance;
            });
        if (!near_visible) errors.surely_wrong.push_back({point.at, point.pixels});
    }
    return errors;
}

} // namespace lineatlas
