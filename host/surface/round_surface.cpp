#include "round_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "surface_point.hpp"

namespace lineatlas {
namespace {

/// Directions whose sine is below this are equal, and so are places nearer than this share of a
/// size.
constexpr double straight = 1e-7;

/// Places along one direction of a surface.
constexpr int samples = 9;
using Row = std::array<glm::dvec3, samples>;

double size_of(const Row& row) {
    double size = 0;
    for (const glm::dvec3& place : row) size = std::max(size, glm::distance(place, row[0]));
    return size;
}

/// Whether all places lie on the line through the first and the last one.
bool is_straight(const Row& row) {
    const glm::dvec3 way = row.back() - row.front();
    const double length = glm::length(way);
    if (!(length > straight * size_of(row))) return false;
    return std::ranges::all_of(row, [&](const glm::dvec3& place) {
        return glm::length(glm::cross(place - row.front(), way)) <= straight * length * length;
    });
}

struct Circle {
    glm::dvec3 center, normal;
    double radius;
};

std::optional<Circle> circle_of(const Row& row) {
    const glm::dvec3 a = row[3] - row[0], b = row[6] - row[0], normal = glm::cross(a, b);
    const double squared = glm::dot(normal, normal);
    if (!(squared > straight * std::pow(size_of(row), 4))) return std::nullopt;
    const glm::dvec3 out =
        (glm::cross(normal, a) * glm::dot(b, b) + glm::cross(b, normal) * glm::dot(a, a)) /
        (2 * squared);
    const Circle circle{row[0] + out, normal / std::sqrt(squared), glm::length(out)};
    for (const glm::dvec3& place : row) {
        const glm::dvec3 from = place - circle.center;
        if (std::abs(glm::length(from) - circle.radius) > straight * circle.radius ||
            std::abs(glm::dot(from, circle.normal)) > straight * circle.radius)
            return std::nullopt;
    }
    return circle;
}

using Grid = std::array<Row, samples>;

Grid turned(const Grid& grid) {
    Grid result;
    for (std::size_t i = 0; i < samples; ++i)
        for (std::size_t j = 0; j < samples; ++j) result[j][i] = grid[i][j];
    return result;
}

/// The revolution whose circles are these rows, if they lie about one axis.
std::optional<SurfaceShape> revolution_of(const Grid& rows) {
    std::optional<Circle> first;
    const double size = std::max(size_of(rows[0]), size_of(turned(rows)[0]));
    for (const Row& row : rows) {
        if (size_of(row) <= straight * size) continue; // a tip
        const std::optional<Circle> circle = circle_of(row);
        if (!circle) return std::nullopt;
        if (!first) first = circle;
        if (glm::length(glm::cross(circle->normal, first->normal)) > straight ||
            glm::length(glm::cross(circle->center - first->center, first->normal)) >
                straight * size)
            return std::nullopt;
    }
    if (!first) return std::nullopt;
    SurfaceShape shape{.point = first->center, .axis = first->normal};
    const Row across = turned(rows)[0];
    if (is_straight(across)) {
        shape.curve = {.point = across.front(), .u = across.back() - across.front()};
    } else if (const auto circle = circle_of(across)) {
        const glm::dvec3 u = across.front() - circle->center;
        shape.curve = {.kind = SurfaceCurve::Kind::ellipse,
                       .point = circle->center,
                       .u = u,
                       .v = glm::cross(circle->normal, u)};
    } else {
        shape.curve.kind = SurfaceCurve::Kind::spline;
    }
    return shape;
}

std::optional<SurfaceShape> plane_of(const Grid& rows) {
    const glm::dvec3 corner = rows[0][0];
    SurfaceShape shape{.kind = SurfaceShape::Kind::extrusion};
    shape.curve = {.point = corner, .u = rows[0].back() - corner};
    shape.axis = rows.back()[0] - corner;
    const glm::dvec3 normal = glm::cross(shape.curve.u, shape.axis);
    const double size = std::max(glm::length(shape.curve.u), glm::length(shape.axis));
    if (!(glm::length(normal) > straight * size * size)) return std::nullopt;
    for (const Row& row : rows)
        for (const glm::dvec3& place : row)
            if (std::abs(glm::dot(place - corner, glm::normalize(normal))) > straight * size)
                return std::nullopt;
    return shape;
}

/// The range of a parameter.
struct Range {
    double from, to;
};
Range range_of(const SplineDirection& along) {
    return {along.knots[along.degree], along.knots[along.knots.size() - 1 - along.degree]};
}
Range range_of(const SurfaceCurve& curve) {
    if (curve.kind == SurfaceCurve::Kind::spline) return range_of(curve.along);
    return {0, curve.kind == SurfaceCurve::Kind::ellipse ? 2 * std::numbers::pi : 1};
}

Grid sampled(const SurfaceShape& shape) {
    const bool is_net = shape.kind == SurfaceShape::Kind::spline;
    const Range u = is_net ? range_of(shape.along_u) : range_of(shape.curve);
    const Range v = is_net ? range_of(shape.along_v) : Range{0, 1};
    Grid grid;
    for (std::size_t i = 0; i < samples; ++i)
        for (std::size_t j = 0; j < samples; ++j)
            grid[i][j] = evaluate(shape, {std::lerp(u.from, u.to, double(i) / (samples - 1)),
                                          std::lerp(v.from, v.to, double(j) / (samples - 1))})
                             .at;
    return grid;
}

double distance_to_axis(const SurfaceShape& shape, glm::dvec3 place) {
    return glm::length(glm::cross(place - shape.point, shape.axis));
}

bool is_circle(const SurfaceCurve& curve) {
    const double u = glm::length(curve.u), v = glm::length(curve.v);
    return curve.kind == SurfaceCurve::Kind::ellipse && std::abs(u - v) <= straight * u;
}

/// How far a place is off the curve of a revolution, turned into the plane of the place.
std::optional<double> distance_to_turned(const SurfaceShape& shape, glm::dvec3 place) {
    const SurfaceCurve& curve = shape.curve;
    const auto flat = [&](glm::dvec3 at) {
        return glm::dvec2{distance_to_axis(shape, at), glm::dot(at - shape.point, shape.axis)};
    };
    const glm::dvec2 at = flat(place);
    if (curve.kind == SurfaceCurve::Kind::line) {
        const double along = glm::dot(curve.u, shape.axis);
        if (along == 0) return std::abs(at.y - flat(curve.point).y);
        // The point of the line at the height of the place. A cone's other half is the same there.
        const double t = (at.y - flat(curve.point).y) / along;
        const glm::dvec3 beside = curve.point + t * curve.u;
        return std::abs(at.x - distance_to_axis(shape, beside)) * std::abs(along) /
               glm::length(curve.u);
    }
    if (!is_circle(curve)) return std::nullopt;
    return std::abs(glm::distance(at, flat(curve.point)) - glm::length(curve.u));
}

std::optional<double> distance_to(const SurfaceShape& shape, glm::dvec3 place) {
    if (shape.offset != 0) return std::nullopt;
    if (shape.kind == SurfaceShape::Kind::revolution) return distance_to_turned(shape, place);
    if (shape.kind != SurfaceShape::Kind::extrusion || shape.curve.kind != SurfaceCurve::Kind::line)
        return std::nullopt;
    const glm::dvec3 normal = glm::normalize(glm::cross(shape.curve.u, shape.axis));
    return std::abs(glm::dot(place - shape.curve.point, normal));
}

} // namespace

SurfaceShape plain_shape(const SurfaceShape& shape) {
    if (shape.kind == SurfaceShape::Kind::revolution) return shape;
    const Grid rows = sampled(shape);
    if (const auto plane = plane_of(rows)) return *plane;
    if (const auto round = revolution_of(rows)) return *round;
    if (const auto round = revolution_of(turned(rows))) return *round;
    return shape;
}

std::optional<AxisLine> axis_of(const SurfaceShape& shape, const PlacedSurface& placed) {
    if (shape.kind != SurfaceShape::Kind::revolution) return std::nullopt;
    const SurfaceCurve& curve = shape.curve;
    if (curve.kind == SurfaceCurve::Kind::line &&
        std::abs(glm::dot(curve.u, shape.axis)) <= straight * glm::length(curve.u))
        return std::nullopt;
    if (is_circle(curve) && distance_to_axis(shape, curve.point) <= straight * glm::length(curve.u))
        return std::nullopt;
    const glm::dmat4x3& m = placed.model_from_shape;
    return AxisLine{.point = m * glm::dvec4{shape.point, 1},
                    .direction = glm::normalize(m * glm::dvec4{shape.axis, 0})};
}

bool holds_place(const SurfaceShape& shape, const PlacedSurface& placed, glm::dvec3 place,
                 double tolerance) {
    const glm::dmat4x3& m = placed.model_from_shape;
    const glm::dmat3 axes{m[0], m[1], m[2]};
    const std::optional<double> distance = distance_to(shape, glm::inverse(axes) * (place - m[3]));
    return distance && *distance * std::cbrt(std::abs(glm::determinant(axes))) <= tolerance;
}

} // namespace lineatlas
