#include "surface_outlines.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace lineatlas {
namespace {

constexpr double rounding_of_eye = 1e-6; ///< cameras are floats
constexpr double same = 1e-9;            ///< of the size of a curve

glm::dvec3 from_axis(const SurfaceShape& shape, const glm::dvec3& place) {
    const glm::dvec3 out = place - shape.point;
    return out - glm::dot(out, shape.axis) * shape.axis;
}

/// The ellipse that turns about an axis, in a plane with it, as of a torus.
class TurnedEllipse {
  public:
    explicit TurnedEllipse(const SurfaceShape& shape)
        : shape_(shape), radius_(glm::length(from_axis(shape, shape.curve.point))),
          outwards_(from_axis(shape, shape.curve.point) / radius_) {
        const SurfaceCurve& curve = shape.curve;
        const double top = std::atan2(glm::dot(curve.v, shape.axis), glm::dot(curve.u, shape.axis));
        top_ = std::abs(glm::dot(std::cos(top) * curve.u + std::sin(top) * curve.v, outwards_));
    }

    bool is_in_plane_with_axis() const {
        const glm::dvec3 across = glm::cross(shape_.axis, outwards_);
        return std::abs(glm::dot(across, shape_.curve.u)) +
                   std::abs(glm::dot(across, shape_.curve.v)) <
               same * size();
    }

    /// Whether a place, given by the way from the axis, is where the surface is level.
    bool is_on_top(const glm::dvec3& out) const {
        constexpr double rounding = 1e-5;
        return std::abs(std::abs(glm::length(out) - radius_) - top_) < rounding * size();
    }

    /// A vector of the ellipse's plane, turned into that of the axis and a direction from it.
    glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& meridian) const {
        return glm::dot(v, shape_.axis) * shape_.axis + glm::dot(v, outwards_) * meridian;
    }

  private:
    double size() const { return glm::length(shape_.curve.u); }

    const SurfaceShape& shape_;
    double radius_;       ///< of the way of its centre
    glm::dvec3 outwards_; ///< from the axis to its centre
    double top_ = 0;      ///< how far its highest place is from above the centre
};

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
    if (!(glm::length(glm::cross(to_eye, axis)) < rounding_of_eye * glm::length(to_eye)))
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
    if (eye_.w != 0 || shape.offset != 0 || shape.curve.kind != SurfaceCurve::Kind::ellipse)
        return nullptr;
    const glm::dmat4 shape_from_model = glm::inverse(glm::dmat4{placed});
    const glm::dvec3 to_eye = glm::normalize(glm::dvec3{shape_from_model * eye_});
    const TurnedEllipse ellipse{shape};
    if (!(std::abs(glm::dot(to_eye, shape.axis)) < rounding_of_eye) ||
        !ellipse.is_in_plane_with_axis())
        return nullptr;
    const auto out_to = [&](glm::dvec3 place) {
        return from_axis(shape, shape_from_model * glm::dvec4{place, 1});
    };
    const auto is_beside = [&](const glm::dvec3& out) {
        constexpr double beside = 0.02; // of a corner of triangles that stands for a place there
        return std::abs(glm::dot(to_eye, out)) < beside * glm::length(out);
    };
    const glm::dvec3 first = out_to(from), last = out_to(to);
    if (!is_beside(first) || !is_beside(last) ||
        (ellipse.is_on_top(first) && ellipse.is_on_top(last)))
        return nullptr;
    const glm::dvec3 sideways = glm::normalize(glm::cross(shape.axis, to_eye));
    const glm::dvec3 meridian = std::copysign(1, glm::dot(sideways, first)) * sideways;
    const auto turned = [&](const glm::dvec3& v) {
        return glm::dmat3{placed} * ellipse.turned(v, meridian);
    };
    return kept(
        {.center = placed * glm::dvec4{shape.point, 1} + turned(shape.curve.point - shape.point),
         .u = turned(shape.curve.u),
         .v = turned(shape.curve.v)});
}

/// The silhouette of a sphere: a circle, smaller the nearer the eye is. Nothing of other shapes.
std::optional<EdgeCurve> SurfaceOutlines::sphere_outline(const SurfaceShape& shape,
                                                         const glm::dmat4x3& placed) const {
    const SurfaceCurve& curve = shape.curve;
    if (shape.kind != SurfaceShape::Kind::revolution || shape.offset != 0 ||
        curve.kind != SurfaceCurve::Kind::ellipse)
        return {};
    const double radius = glm::length(curve.u);
    if (std::abs(glm::length(curve.v) - radius) > same * radius ||
        glm::length(from_axis(shape, curve.point)) > same * radius)
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
