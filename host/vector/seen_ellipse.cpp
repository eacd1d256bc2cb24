#include "seen_ellipse.hpp"

#include <algorithm>
#include <cmath>

namespace lineatlas {
namespace {

constexpr double as_circle = 1e-3;  ///< pixels by which the axes of one may differ
constexpr double same_curve = 1e-3; ///< pixels

} // namespace

std::optional<Ellipse> Ellipse::seen(const EdgeCurve& curve, const glm::dmat4& clip_from_world,
                                     glm::dvec2 size) {
    const auto on_screen = [&](glm::dvec3 at, double w) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4{at, w};
        return glm::dvec3{0.5 * size.x * (clip.x + clip.w), 0.5 * size.y * (clip.w - clip.y),
                          clip.w};
    };
    glm::dvec3 u = on_screen(curve.u, 0), v = on_screen(curve.v, 0);
    glm::dvec3 c = on_screen(curve.center, 1);
    if (!(c.z > 0)) return {};
    // Beside its centre no digits are lost.
    const glm::dvec2 beside = glm::dvec2{c} / c.z;
    for (glm::dvec3* column : {&u, &v, &c}) *column -= glm::dvec3{beside * column->z, 0};
    const auto dual = [&](int i, int k) { return u[i] * u[k] + v[i] * v[k] - c[i] * c[k]; };
    const double scale = -dual(2, 2);
    if (!(scale > 0)) return {}; // reaches behind the eye
    const glm::dvec2 center = -glm::dvec2{dual(0, 2), dual(1, 2)} / scale;
    const double xx = dual(0, 0) / scale + center.x * center.x;
    const double xy = dual(0, 1) / scale + center.x * center.y;
    const double yy = dual(1, 1) / scale + center.y * center.y;
    const double half = std::hypot(0.5 * (xx - yy), xy);
    const double major = std::sqrt(0.5 * (xx + yy) + half);
    const double minor = std::sqrt(std::max(0.0, xx * yy - xy * xy)) / major;
    if (!(minor >= flattest) || !std::isfinite(major)) return {};
    Ellipse result;
    result.arc_.center = beside + center;
    if (major - minor < as_circle) {
        result.arc_.major = {0.5 * (major + minor), 0};
    } else {
        const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
        result.arc_.major = major * glm::dvec2{std::cos(angle), std::sin(angle)};
        result.arc_.ratio = minor / major;
    }
    return result;
}

bool Ellipse::is(const Ellipse& other) const {
    return glm::distance(arc_.center, other.arc_.center) < same_curve &&
           std::abs(minor() - other.minor()) < same_curve &&
           std::min(glm::distance(arc_.major, other.arc_.major),
                    glm::distance(arc_.major, -other.arc_.major)) < same_curve;
}

} // namespace lineatlas
