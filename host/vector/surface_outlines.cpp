#include "surface_outlines.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "surface/plane_section.hpp"
#include "surface/round_surface.hpp"

namespace lineatlas {
namespace {

constexpr double same = 1e-9; ///< of the size of a curve

/// Whether a place, given by the way from the axis, is where the turning ellipse is highest or
/// lowest along the axis.
bool is_on_top(const SurfaceShape& shape, const glm::dvec3& out) {
    constexpr double rounding = 1e-5;
    const SurfaceCurve& curve = shape.curve;
    const glm::dvec3 own = way_from_axis(shape, curve.point);
    const double top = std::atan2(glm::dot(curve.v, shape.axis), glm::dot(curve.u, shape.axis));
    const glm::dvec3 to_top = std::cos(top) * curve.u + std::sin(top) * curve.v;
    const double off = std::abs(glm::dot(to_top, glm::normalize(own)));
    return std::abs(std::abs(glm::length(out) - glm::length(own)) - off) <
           rounding * glm::length(curve.u);
}

} // namespace

const Ellipse* SurfaceOutlines::between(std::uint32_t surface, glm::dvec3 from, glm::dvec3 to) {
    if (const Ellipse* const sphere = of_sphere(surface)) return sphere;
    const PlacedSurface& placed = surfaces_.surfaces[surface];
    const SurfaceShape& shape = surfaces_.shapes[placed.shape];
    if (shape.kind != SurfaceShape::Kind::revolution) return nullptr;
    const Ellipse* const parallel = around_axis(shape, placed.model_from_shape, from);
    return parallel != nullptr ? parallel
                               : along_meridian(shape, placed.model_from_shape, from, to);
}

const Ellipse* SurfaceOutlines::of_sphere(std::uint32_t surface) {
    const auto [entry, fresh] = spheres_.try_emplace(surface);
    if (fresh) {
        const PlacedSurface& placed = surfaces_.surfaces[surface];
        if (const std::optional<EdgeCurve> outline =
                sphere_outline(surfaces_.shapes[placed.shape], placed.model_from_shape))
            entry->second = seen(*outline);
    }
    return entry->second ? &*entry->second : nullptr;
}

/// The circle about the axis of a revolution through a place of its silhouette, if the eye is on
/// the axis.
const Ellipse* SurfaceOutlines::around_axis(const SurfaceShape& shape, const glm::dmat4x3& placed,
                                            glm::dvec3 place) {
    const glm::dvec3 axis = glm::normalize(glm::dmat3{placed} * shape.axis);
    const glm::dvec3 foot = placed * glm::dvec4{shape.point, 1};
    const glm::dvec3 to_eye = glm::dvec3{eye_} - foot * eye_.w;
    if (!(glm::length(glm::cross(to_eye, axis)) < rounding_of_views * glm::length(to_eye)))
        return nullptr;
    const glm::dvec3 center = foot + glm::dot(place - foot, axis) * axis;
    const glm::dvec3 out = place - center;
    return kept({.center = center, .u = out, .v = glm::cross(axis, out)});
}

/// The ellipse of a revolution, turned to where a level parallel view sees its silhouette beside
/// the axis. Null on a parallel, which such a view sees edge on.
const Ellipse* SurfaceOutlines::along_meridian(const SurfaceShape& shape,
                                               const glm::dmat4x3& placed, glm::dvec3 from,
                                               glm::dvec3 to) {
    if (eye_.w != 0) return nullptr;
    const glm::dmat4 shape_from_model = glm::inverse(glm::dmat4{placed});
    const glm::dvec3 to_eye = glm::normalize(glm::dvec3{shape_from_model * eye_});
    if (!(std::abs(glm::dot(to_eye, shape.axis)) < rounding_of_views)) return nullptr;
    const auto out_to = [&](glm::dvec3 place) {
        return way_from_axis(shape, shape_from_model * glm::dvec4{place, 1});
    };
    const auto is_beside = [&](const glm::dvec3& out) {
        constexpr double beside = 0.02; // of a corner of triangles that stands for a place there
        return std::abs(glm::dot(to_eye, out)) < beside * glm::length(out);
    };
    const glm::dvec3 first = out_to(from), last = out_to(to);
    if (!is_beside(first) || !is_beside(last)) return nullptr;
    const glm::dvec3 sideways = glm::cross(shape.axis, to_eye);
    const std::optional<SurfaceCurve> ellipse =
        meridian_ellipse(shape, std::copysign(1, glm::dot(sideways, first)) * sideways);
    if (!ellipse || (is_on_top(shape, first) && is_on_top(shape, last))) return nullptr;
    return kept({.center = placed * glm::dvec4{ellipse->point, 1},
                 .u = glm::dmat3{placed} * ellipse->u,
                 .v = glm::dmat3{placed} * ellipse->v});
}

/// The silhouette of a sphere: a circle, smaller the nearer the eye is. Nothing for other shapes.
std::optional<EdgeCurve> SurfaceOutlines::sphere_outline(const SurfaceShape& shape,
                                                         const glm::dmat4x3& placed) const {
    const SurfaceCurve& curve = shape.curve;
    if (shape.kind != SurfaceShape::Kind::revolution || shape.offset != 0 ||
        curve.kind != SurfaceCurve::Kind::ellipse)
        return {};
    const double radius = glm::length(curve.u);
    if (std::abs(glm::length(curve.v) - radius) > same * radius ||
        glm::length(way_from_axis(shape, curve.point)) > same * radius)
        return {};
    const glm::dvec3 center = placed * glm::dvec4{curve.point, 1};
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3{placed})));
    const glm::dvec3 to_eye = glm::dvec3{eye_} - center * eye_.w;
    const double distance = glm::length(to_eye), seen = scale * radius;
    if (!(distance > (eye_.w != 0 ? seen : 0))) return {};
    const glm::dvec3 way = to_eye / distance;
    const double sine = eye_.w != 0 ? seen / distance : 0;
    const glm::dvec3 aside{std::abs(way.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0}};
    const double half = seen * std::sqrt(1 - sine * sine);
    const glm::dvec3 u = half * glm::normalize(glm::cross(way, aside));
    return EdgeCurve{.center = center + seen * sine * way, .u = u, .v = glm::cross(way, u)};
}

std::optional<Ellipse> SurfaceOutlines::seen(const EdgeCurve& curve) const {
    return Ellipse::seen(curve, clip_from_world_, size_);
}

const Ellipse* SurfaceOutlines::kept(const EdgeCurve& curve) {
    const std::optional<Ellipse> ellipse = seen(curve);
    if (!ellipse) return nullptr;
    if (of_revolutions_.empty() || !ellipse->is(of_revolutions_.back()))
        of_revolutions_.push_back(*ellipse);
    return &of_revolutions_.back();
}

} // namespace lineatlas
