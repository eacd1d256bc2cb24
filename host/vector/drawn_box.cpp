#include "drawn_box.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>

namespace lineatlas {
namespace {

constexpr double turn = 2 * std::numbers::pi;

void widen(DrawnBox& box, glm::dvec2 at) {
    box.low = glm::min(box.low, at);
    box.high = glm::max(box.high, at);
}

bool is_on(const VectorArc& arc, double angle) {
    const double from = arc.sweep < 0 ? arc.from + arc.sweep : arc.from;
    return angle - from - turn * std::floor((angle - from) / turn) <= std::abs(arc.sweep);
}

/// Adds the ends of an arc, and the places where it turns back along x or y.
void widen(DrawnBox& box, const VectorArc& arc) {
    const glm::dvec2 minor = arc.ratio * glm::dvec2{-arc.major.y, arc.major.x};
    widen(box, arc.at(arc.from));
    widen(box, arc.at(arc.from + arc.sweep));
    for (int axis = 0; axis < 2; ++axis) {
        const double angle = std::atan2(minor[axis], arc.major[axis]);
        for (const double extreme : {angle, angle + std::numbers::pi})
            if (is_on(arc, extreme)) widen(box, arc.at(extreme));
    }
}

/// Adds the places where a cubic Bézier curve from `a` to `d` turns back along x or y.
void widen(DrawnBox& box, glm::dvec2 a, const VectorCubic& cubic, glm::dvec2 d) {
    const glm::dvec2 b = cubic.first_control, c = cubic.last_control;
    const glm::dvec2 square = d - a + 3.0 * (b - c), linear = 2.0 * (a - 2.0 * b + c);
    const glm::dvec2 constant = b - a; // a third of the derivative
    const auto at = [&](double t) {
        const double s = 1 - t;
        return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
    };
    for (int axis = 0; axis < 2; ++axis) {
        const double inner = linear[axis] * linear[axis] - 4 * square[axis] * constant[axis];
        if (inner < 0) continue;
        // Both forms of the roots are used, because one root stays finite if the square term is
        // nearly 0.
        const double q = -0.5 * (linear[axis] + std::copysign(std::sqrt(inner), linear[axis]));
        for (const double t : std::array{q / square[axis], constant[axis] / q})
            if (t > 0 && t < 1) widen(box, at(t));
    }
}

bool is_larger(const DrawnBox& a, const DrawnBox& b) {
    constexpr double same = 1e-4; // pixels
    return a.low.x < b.low.x - same || a.low.y < b.low.y - same || a.high.x > b.high.x + same ||
           a.high.y > b.high.y + same;
}

} // namespace

DrawnBox drawn_box(const VectorDrawing& drawing) {
    const glm::dvec2 far{std::numeric_limits<double>::infinity()};
    DrawnBox straight{.low = far, .high = -far};
    DrawnBox curved = straight;
    for (const VectorPath& path : drawing.paths) {
        for (const VectorPoint& point : path.points) widen(straight, point.at);
        for (const VectorCurve& curve : path.curves) {
            if (curve.cubic)
                widen(curved, path.points[curve.first].at, *curve.cubic,
                      path.points[curve.last].at);
            else
                widen(straight, curve.arc);
        }
    }
    DrawnBox box{.low = glm::min(straight.low, curved.low),
                 .high = glm::max(straight.high, curved.high)};
    box.exact = !is_larger(box, straight);
    return box;
}

} // namespace lineatlas
