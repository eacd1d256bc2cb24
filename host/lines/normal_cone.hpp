#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lineatlas {

/// A cone around the normals of faces. Normals n and -n count as one. It may be a little wider than
/// needed, never narrower.
struct NormalCone {
    glm::dvec3 axis{0};
    double half_angle = -1; ///< radians; below 0: no face; from pi / 2 on: all directions

    static NormalCone of(glm::dvec3 normal) {
        return normal == glm::dvec3{0} ? NormalCone{} : NormalCone{normal, 0};
    }

    static NormalCone around(const NormalCone& a, const NormalCone& b) {
        if (a.half_angle < 0) return b;
        if (b.half_angle < 0) return a;
        const double angle = angle_between(a.axis, b.axis);
        if (angle + b.half_angle <= a.half_angle) return a;
        if (angle + a.half_angle <= b.half_angle) return b;
        const double half = 0.5 * (angle + a.half_angle + b.half_angle);
        if (half >= 0.5 * std::numbers::pi) return {a.axis, std::numbers::pi};
        const glm::dvec3 other = glm::dot(a.axis, b.axis) < 0 ? -b.axis : b.axis;
        const double turn = half - a.half_angle; // of the axis, from a towards b
        const double whole = std::max(std::sin(angle), 1e-300);
        const glm::dvec3 axis =
            a.axis * (std::sin(angle - turn) / whole) + other * (std::sin(turn) / whole);
        return {glm::normalize(axis), half + rounding};
    }

    /// False only if all faces of one cone lie at less than `angle`, at most 1, to all faces of the
    /// other.
    static bool may_differ(const NormalCone& a, const NormalCone& b, double angle) {
        if (a.half_angle < 0 || b.half_angle < 0) return false;
        const double left = angle - a.half_angle - b.half_angle - rounding;
        // The sine of `left` is no less than the two terms.
        return left <= 0 || sine_between(a.axis, b.axis) > left - left * left * left / 6;
    }

    /// False only if all faces lie at more than `angle` to a normal.
    bool may_be_along(glm::dvec3 normal, double angle) const {
        if (half_angle < 0) return false;
        const double most = half_angle + angle + rounding;
        if (most >= 1) return true;
        const glm::dvec3 across = glm::cross(axis, normal);
        return glm::dot(across, across) <= most * most;
    }

  private:
    static constexpr double rounding = 1e-6;

    static double sine_between(glm::dvec3 a, glm::dvec3 b) { return glm::length(glm::cross(a, b)); }

    /// The angle between two lines, 0 to pi / 2. An arc cosine would round small angles.
    static double angle_between(glm::dvec3 a, glm::dvec3 b) {
        return std::atan2(sine_between(a, b), std::abs(glm::dot(a, b)));
    }
};

} // namespace lineatlas
