#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/plane_vectors.hpp"

namespace lineatlas {

/// A circle in a plane.
struct Circle {
    glm::dvec2 center;
    double radius;

    double distance(glm::dvec2 point) const { return glm::distance(point, center) - radius; }
    glm::dvec2 nearest(glm::dvec2 point) const {
        return center + radius * glm::normalize(point - center);
    }
    /// The angle from one point to the next, -180 to 180 degrees.
    double angle(glm::dvec2 from, glm::dvec2 to) const {
        return angle_between(from - center, to - center);
    }
    double sagitta(double angle) const { return radius * (1 - std::cos(0.5 * angle)); }
    /// Whether points that are this angle apart, above 0, are near enough to tell an arc from other
    /// curves. Small circles lose points when paths are simplified, so a longer step will do if its
    /// chord is near to the arc.
    bool is_told_by(double angle) const {
        constexpr double small_sagitta = 0.06; // pixels
        return angle <= largest_step || sagitta(angle) <= small_sagitta;
    }

    /// A twelfth of a circle, and rounding.
    static constexpr double largest_step = 30.5 * std::numbers::pi / 180;
};

/// The circle with the least squares of the points' distances from it (Gauss-Newton); nothing where
/// points lie on a line.
std::optional<Circle> fit_circle(std::span<const glm::dvec2> points);

} // namespace lineatlas
