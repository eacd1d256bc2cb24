#pragma once

#include <optional>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "lineatlas/mesh.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// What a circle or an ellipse in space looks like on the screen. Its dual conic is that of the
/// unit circle under the map from it to the screen (Hartley and Zisserman, "Multiple View Geometry
/// in Computer Vision", 2004, result 8.6 for duals), from which its centre and axes can be read.
class Ellipse {
  public:
    /// Half the shorter axis of the flattest ellipse, pixels.
    static constexpr double flattest = 0.5;

    /// Nothing for a curve that looks flatter, or reaches behind the eye.
    static std::optional<Ellipse> seen(const EdgeCurve& curve, const glm::dmat4& clip_from_world,
                                       glm::dvec2 size);

    /// The arc from one angle on.
    VectorArc arc(double from, double sweep) const {
        VectorArc result = arc_;
        result.from = from;
        result.sweep = sweep;
        return result;
    }

    /// Where the ellipse is the unit circle.
    glm::dvec2 unrolled(glm::dvec2 at) const {
        const double squared = glm::dot(arc_.major, arc_.major);
        const glm::dvec2 out = at - arc_.center;
        return {glm::dot(out, arc_.major) / squared,
                glm::dot(out, glm::dvec2{-arc_.major.y, arc_.major.x}) / (squared * arc_.ratio)};
    }

    /// The point of it in the direction of another from the centre.
    glm::dvec2 towards(glm::dvec2 at) const {
        return arc_.center + (at - arc_.center) / glm::length(unrolled(at));
    }

    double minor() const { return arc_.ratio * glm::length(arc_.major); }

    /// Whether it is the same within a thousandth of a pixel.
    bool is(const Ellipse& other) const;

  private:
    VectorArc arc_;
};

} // namespace lineatlas
