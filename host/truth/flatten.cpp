#include "flatten.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

constexpr double most_off = 0.002;
constexpr double most_chords = 512; ///< of a full circle; a cubic has at most an eighth of that

} // namespace

int chords_of_arc(double radius, double sweep) {
    // A chord over the angle a is off by r (1 - cos(a / 2)).
    const double finest = 2 * std::numbers::pi / most_chords;
    const double share = std::min(1.0, most_off / std::max(radius, most_off));
    const double angle = std::max(finest, 2 * std::acos(1 - share));
    return std::max(
        1, static_cast<int>(std::ceil(std::min(std::abs(sweep), 2 * std::numbers::pi) / angle)));
}

void append_cubic(glm::dvec2 from, const VectorCubic& cubic, glm::dvec2 to,
                  std::vector<glm::dvec2>& points) {
    const glm::dvec2 a = cubic.first_control, b = cubic.last_control;
    // A chord over the step h is off by h² / 8 of the second derivative at most.
    const double bend =
        6 * std::max(glm::length(from - 2.0 * a + b), glm::length(a - 2.0 * b + to));
    const double wanted = std::ceil(std::sqrt(bend / (8 * most_off)));
    const int chords = static_cast<int>(std::clamp(wanted, 1.0, most_chords / 8));
    for (int i = 1; i < chords; ++i) {
        const double t = static_cast<double>(i) / chords, s = 1 - t;
        points.push_back(s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
    }
    points.push_back(to);
}

std::vector<glm::dvec2> flattened(std::span<const glm::dvec2> points,
                                  std::span<const VectorCurve> curves) {
    std::vector<glm::dvec2> result;
    std::size_t done = 0; // points done so far
    const auto add_through = [&](std::size_t last) {
        for (; done <= last; ++done) result.push_back(points[done]);
    };
    for (const VectorCurve& curve : curves) {
        const bool in_order = curve.first + std::size_t{1} >= done && curve.first < curve.last;
        if (!in_order || curve.last >= points.size()) continue;
        add_through(curve.first);
        if (curve.cubic) {
            append_cubic(points[curve.first], *curve.cubic, points[curve.last], result);
        } else {
            const VectorArc& arc = curve.arc;
            const double radius = glm::length(arc.major) * std::max(1.0, arc.ratio);
            const int chords = chords_of_arc(radius, arc.sweep);
            for (int i = 1; i < chords; ++i)
                result.push_back(arc.at(arc.from + arc.sweep * i / chords));
            result.push_back(points[curve.last]);
        }
        done = std::size_t{curve.last} + 1;
    }
    if (!points.empty()) add_through(points.size() - 1);
    return result;
}

} // namespace lineatlas
