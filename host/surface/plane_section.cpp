#include "plane_section.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "round_surface.hpp"
#include "surface_point.hpp"

namespace lineatlas {
namespace {

/// Sines below this are 0, and so are shares of a size.
constexpr double straight = 1e-7;
/// The sine of the angle between a line and a surface that it touches, at most.
constexpr double touches = 0.02;

/// A plane in the coordinates of a shape.
struct Plane {
    glm::dvec3 point, normal;
};

/// The place of a surface on a plane, by Newton's method from the place of two parameters. `free`
/// has 1 for a parameter that may change and 0 for the other.
std::optional<glm::dvec3> place_on(const SurfaceShape& shape, const Plane& plane, glm::dvec2 at,
                                   glm::dvec2 free) {
    for (int i = 0; i < 12; ++i) {
        const SurfacePoint place = evaluate(shape, at);
        const double distance = glm::dot(place.at - plane.point, plane.normal);
        const double u = glm::length(place.u), v = glm::length(place.v);
        if (std::abs(distance) <= 1e-12 * (glm::length(place.at) + u + v)) return place.at;
        // Each parameter moves the place by as much as it turns it to the plane.
        const glm::dvec2 slope = free * glm::dvec2{u > 0 ? glm::dot(place.u, plane.normal) / u : 0,
                                                   v > 0 ? glm::dot(place.v, plane.normal) / v : 0};
        const double gain = glm::dot(slope, slope);
        if (!(gain > straight * straight)) return std::nullopt;
        at -= distance / gain * glm::dvec2{u > 0 ? slope.x / u : 0, v > 0 ? slope.y / v : 0};
    }
    return std::nullopt;
}

/// The same, along one parameter where both lead nowhere: splines do not go on beyond their ends.
std::optional<glm::dvec3> place_on(const SurfaceShape& shape, const Plane& plane, glm::dvec2 at) {
    for (const glm::dvec2& free : {glm::dvec2{1, 1}, glm::dvec2{0, 1}, glm::dvec2{1, 0}})
        if (const std::optional<glm::dvec3> place = place_on(shape, plane, at, free)) return place;
    return std::nullopt;
}

glm::dmat3 axes_of(const PlacedSurface& placed) {
    const glm::dmat4x3& m = placed.model_from_shape;
    return {m[0], m[1], m[2]};
}

Plane plane_of(const PlacedSurface& placed, glm::dvec3 point, glm::dvec3 normal) {
    const glm::dmat3 axes = axes_of(placed);
    return {glm::inverse(axes) * (point - placed.model_from_shape[3]),
            glm::normalize(glm::transpose(axes) * normal)};
}

/// The circle about the axis through a place.
std::optional<SurfaceCurve> around_axis(const SurfaceShape& plain, glm::dvec3 place) {
    const glm::dvec3 out = way_from_axis(plain, place);
    if (!(glm::length(out) > 0)) return std::nullopt;
    return SurfaceCurve{.kind = SurfaceCurve::Kind::ellipse,
                        .point = place - out,
                        .u = out,
                        .v = glm::cross(plain.axis, out)};
}

/// The square of the distance from the axis as a polynomial of the height above `shape.point`.
struct Quadric {
    double constant, linear, square;
};

/// The quadric of a surface that a line makes by turning (a cylinder, a cone or a hyperboloid), or
/// of a sphere.
std::optional<Quadric> quadric_of(const SurfaceShape& shape) {
    const SurfaceCurve& curve = shape.curve;
    if (shape.offset != 0) return std::nullopt;
    const glm::dvec3 out = way_from_axis(shape, curve.point);
    const double height = glm::dot(curve.point - shape.point, shape.axis);
    if (curve.kind == SurfaceCurve::Kind::line) {
        const double rise = glm::dot(curve.u, shape.axis);
        if (!(std::abs(rise) > straight * glm::length(curve.u))) return std::nullopt;
        const glm::dvec3 slope = (curve.u - rise * shape.axis) / rise;
        const glm::dvec3 foot = out - height * slope;
        return Quadric{glm::dot(foot, foot), 2 * glm::dot(foot, slope), glm::dot(slope, slope)};
    }
    const double radius = glm::length(curve.u);
    if (curve.kind != SurfaceCurve::Kind::ellipse || glm::length(out) > straight * radius ||
        std::abs(glm::length(curve.v) - radius) > straight * radius)
        return std::nullopt;
    return Quadric{radius * radius - height * height, 2 * height, -1};
}

/// In coordinates of the plane, of which the first is the axis as seen there, the conic has no
/// mixed term.
std::optional<SurfaceCurve> aslant(const SurfaceShape& shape, const Plane& plane) {
    const std::optional<Quadric> quadric = quadric_of(shape);
    if (!quadric) return std::nullopt;
    const glm::dvec3 sideways = glm::normalize(glm::cross(plane.normal, shape.axis));
    const glm::dvec3 upwards = glm::cross(sideways, plane.normal);
    const double rise = glm::dot(upwards, shape.axis);
    const glm::dvec3 out = plane.point - shape.point;
    const double height = glm::dot(out, shape.axis), bend = 1 + quadric->square;
    const double square = 1 - bend * rise * rise;
    if (!(square > straight)) return std::nullopt; // a parabola or a hyperbola
    const double linear = glm::dot(out, upwards) - (bend * height + 0.5 * quadric->linear) * rise;
    const double linear_aside = glm::dot(out, sideways);
    const double constant =
        glm::dot(out, out) - quadric->constant - (bend * height + quadric->linear) * height;
    const double size = linear * linear / square + linear_aside * linear_aside - constant;
    if (!(size > 0)) return std::nullopt;
    return SurfaceCurve{.kind = SurfaceCurve::Kind::ellipse,
                        .point = plane.point - linear / square * upwards - linear_aside * sideways,
                        .u = std::sqrt(size / square) * upwards,
                        .v = std::sqrt(size) * sideways};
}

std::optional<SurfaceCurve> section_of(const SurfaceShape& shape, const SurfaceShape& plain,
                                       const Plane& plane, glm::dvec2 at) {
    const bool is_across = glm::length(glm::cross(plane.normal, plain.axis)) < straight;
    if (!is_across)
        if (const std::optional<SurfaceCurve> ellipse = aslant(plain, plane)) return ellipse;
    const std::optional<glm::dvec3> place = place_on(shape, plane, at);
    if (!place) return std::nullopt;
    if (is_across) return around_axis(plain, *place);
    const bool holds_axis = std::abs(glm::dot(plane.normal, plain.axis)) < straight &&
                            std::abs(glm::dot(plane.normal, plane.point - plain.point)) <
                                straight * glm::length(*place - plain.point);
    return holds_axis ? meridian_ellipse(plain, way_from_axis(plain, *place)) : std::nullopt;
}

} // namespace

std::optional<SurfaceCurve> meridian_ellipse(const SurfaceShape& shape, glm::dvec3 out) {
    const SurfaceCurve& curve = shape.curve;
    if (shape.kind != SurfaceShape::Kind::revolution || shape.offset != 0 ||
        curve.kind != SurfaceCurve::Kind::ellipse)
        return std::nullopt;
    const glm::dvec3 own = way_from_axis(shape, curve.point);
    const double size = glm::length(curve.u), radius = glm::length(own);
    if (!(radius > straight * size)) return std::nullopt;
    const glm::dvec3 across = glm::cross(shape.axis, own / radius);
    if (std::abs(glm::dot(across, curve.u)) + std::abs(glm::dot(across, curve.v)) > straight * size)
        return std::nullopt;
    const glm::dvec3 meridian = glm::normalize(out - glm::dot(out, shape.axis) * shape.axis);
    const auto turned = [&](const glm::dvec3& v) {
        return glm::dot(v, shape.axis) * shape.axis + glm::dot(v, own) / radius * meridian;
    };
    return SurfaceCurve{.kind = SurfaceCurve::Kind::ellipse,
                        .point = shape.point + turned(curve.point - shape.point),
                        .u = turned(curve.u),
                        .v = turned(curve.v)};
}

std::optional<SurfaceCurve> plane_section(const SurfaceShape& shape, const SurfaceShape& plain,
                                          const PlacedSurface& placed, glm::dvec3 point,
                                          glm::dvec3 normal, glm::dvec2 at) {
    if (plain.kind != SurfaceShape::Kind::revolution) return std::nullopt;
    const glm::dmat3 axes = axes_of(placed);
    std::optional<SurfaceCurve> curve =
        section_of(shape, plain, plane_of(placed, point, normal), at);
    if (!curve) return std::nullopt;
    curve->point = placed.model_from_shape * glm::dvec4{curve->point, 1};
    curve->u = axes * curve->u;
    curve->v = axes * curve->v;
    const double skew = std::abs(glm::dot(curve->u, curve->v));
    if (!(skew <= straight * glm::length(curve->u) * glm::length(curve->v))) return std::nullopt;
    return curve;
}

bool is_cut_straight(const SurfaceShape& plain, const PlacedSurface& placed, glm::dvec3 point,
                     glm::dvec3 normal) {
    const SurfaceCurve& line = plain.curve;
    if (plain.offset != 0 || line.kind != SurfaceCurve::Kind::line) return false;
    if (plain.kind == SurfaceShape::Kind::extrusion) return true; // a plane
    if (plain.kind != SurfaceShape::Kind::revolution) return false;
    const double length = glm::length(line.u);
    if (std::abs(glm::dot(line.u, plain.axis)) < straight * length) return true; // a plane too
    const Plane plane = plane_of(placed, point, normal);
    if (!(std::abs(glm::dot(plane.normal, plain.axis)) < straight)) return false;
    if (glm::length(glm::cross(line.u, plain.axis)) < straight * length) return true; // a cylinder
    const glm::dvec3 out = way_from_axis(plain, line.point);
    const bool is_cone = std::abs(glm::dot(glm::cross(out, line.u), plain.axis)) <=
                         straight * glm::length(out) * length;
    const double size = glm::length(line.point - plain.point) + length;
    return is_cone && std::abs(glm::dot(plane.normal, plane.point - plain.point)) < straight * size;
}

std::optional<glm::dvec3> place_on_plane(const SurfaceShape& shape, const PlacedSurface& placed,
                                         glm::dvec3 point, glm::dvec3 normal, glm::dvec2 at) {
    const auto place = place_on(shape, plane_of(placed, point, normal), at);
    if (!place) return std::nullopt;
    return placed.model_from_shape * glm::dvec4{*place, 1};
}

std::optional<glm::dvec3> place_on_line(const SurfaceShape& shape, const PlacedSurface& placed,
                                        glm::dvec3 from, glm::dvec3 way, glm::dvec2 at) {
    const glm::dmat3 axes = axes_of(placed);
    double along = 0;
    for (int i = 0; i < 12; ++i) {
        const SurfacePoint surface = evaluate(shape, at);
        const glm::dvec3 place = placed.model_from_shape * glm::dvec4{surface.at, 1};
        const glm::dvec3 off = from + along * way - place;
        const glm::dmat3 change{axes * surface.u, axes * surface.v, -way};
        const double size =
            glm::length(change[0]) * glm::length(change[1]) * glm::length(change[2]);
        if (!(std::abs(glm::determinant(change)) > touches * size)) return std::nullopt;
        const double whole = glm::length(from) + glm::length(way) + glm::length(axes * surface.at);
        if (glm::length(off) <= 1e-12 * (whole + glm::length(placed.model_from_shape[3])))
            return place;
        const glm::dvec3 step = glm::inverse(change) * off;
        at += glm::dvec2{step};
        along += step.z;
    }
    return std::nullopt;
}

std::optional<glm::dvec3> place_on_both(const SurfaceShape& shape, const PlacedSurface& placed,
                                        glm::dvec2 at, const SurfaceShape& other,
                                        const PlacedSurface& other_placed, glm::dvec2 other_at,
                                        glm::dvec3 point, glm::dvec3 normal) {
    const glm::dmat3 axes = axes_of(placed), other_axes = axes_of(other_placed);
    const glm::dvec3 across = glm::normalize(normal);
    for (int i = 0; i < 16; ++i) {
        const SurfacePoint one = evaluate(shape, at), two = evaluate(other, other_at);
        const glm::dvec3 place = placed.model_from_shape * glm::dvec4{one.at, 1},
                         its = other_placed.model_from_shape * glm::dvec4{two.at, 1};
        const glm::dvec4 off{place - its, glm::dot(place - point, across)};
        const glm::dvec3 u = axes * one.u, v = axes * one.v, its_u = other_axes * two.u,
                         its_v = other_axes * two.v;
        const double size = glm::length(axes * one.at) + glm::length(other_axes * two.at) +
                            glm::length(placed.model_from_shape[3]) +
                            glm::length(other_placed.model_from_shape[3]) + glm::length(point);
        if (glm::length(off) <= 1e-12 * size) {
            const glm::dvec3 way = glm::cross(glm::cross(u, v), across),
                             its_way = glm::cross(glm::cross(its_u, its_v), across);
            const double sine = glm::length(glm::cross(way, its_way));
            if (!(sine > touches * glm::length(way) * glm::length(its_way))) return std::nullopt;
            return place;
        }
        const glm::dmat4 change{glm::dvec4{u, glm::dot(u, across)},
                                glm::dvec4{v, glm::dot(v, across)}, glm::dvec4{-its_u, 0},
                                glm::dvec4{-its_v, 0}};
        const double volume =
            glm::length(u) * glm::length(v) * glm::length(its_u) * glm::length(its_v);
        if (!(std::abs(glm::determinant(change)) > straight * volume)) return std::nullopt;
        const glm::dvec4 step = glm::inverse(change) * off;
        at -= glm::dvec2{step.x, step.y};
        other_at -= glm::dvec2{step.z, step.w};
    }
    return std::nullopt;
}

} // namespace lineatlas
