#include "surface_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// A value and how it changes: first and second derivatives.
template <class Value>
struct Jet {
    Value at{0}, first{0}, second{0};
};

/// The basis functions of a B-spline that are not zero at a parameter, with two derivatives.
class Basis {
  public:
    Basis(const SplineDirection& along, double t) : degree_(along.degree) {
        const std::vector<double>& knots = along.knots;
        const std::size_t poles = knots.size() - degree_ - 1;
        t = std::clamp(t, knots[degree_], knots[poles]);
        const auto above = std::upper_bound(knots.begin() + degree_ + 1,
                                            knots.begin() + static_cast<std::ptrdiff_t>(poles), t);
        span_ = static_cast<std::size_t>(above - knots.begin()) - 1;
        fill(knots, t);
    }

    std::size_t first() const { return span_ - degree_; } ///< pole
    std::uint32_t count() const { return degree_ + 1; }
    double at(std::uint32_t i) const { return values_[0][i]; }
    double first_derivative(std::uint32_t i) const { return values_[1][i]; }
    double second_derivative(std::uint32_t i) const { return values_[2][i]; }

  private:
    static constexpr std::size_t most = SplineDirection::most_degree + 1;
    using Values = std::array<double, most + 1>;

    /// Computes them by the recursion of Cox and de Boor. Derivatives are differences of functions
    /// of a lower degree (de Boor, "A Practical Guide to Splines", 1978, chapter X).
    void fill(const std::vector<double>& knots, double t) {
        Values lower{}; // of degree k; entry j is of pole span - k + j
        lower[0] = 1;
        std::array<Values, 2> kept{}; // values of the two degrees before the last
        for (std::uint32_t k = 1; k <= degree_; ++k) {
            if (k == degree_) kept[0] = lower;
            if (k + 1 == degree_) kept[1] = lower;
            Values next{};
            for (std::uint32_t j = 0; j < k; ++j) {
                const std::size_t pole = span_ - k + 1 + j; // of degree k - 1
                const double low = knots[pole], high = knots[pole + k];
                const double share = high > low ? lower[j] / (high - low) : 0;
                next[j] += (high - t) * share;
                next[j + 1] += (t - low) * share;
            }
            lower = next;
        }
        values_[0] = lower;
        values_[1] = derivative(knots, kept[0], degree_);
        if (degree_ > 1)
            values_[2] = derivative(knots, derivative(knots, kept[1], degree_ - 1), degree_);
    }

    /// Derivatives of functions of degree k, from functions of degree k - 1 or their derivatives.
    Values derivative(const std::vector<double>& knots, const Values& lower,
                      std::uint32_t k) const {
        Values result{};
        for (std::uint32_t j = 0; j < k; ++j) {
            const std::size_t pole = span_ - k + 1 + j;
            const double width = knots[pole + k] - knots[pole];
            const double slope = width > 0 ? k * lower[j] / width : 0;
            result[j] -= slope;
            result[j + 1] += slope;
        }
        return result;
    }

    std::uint32_t degree_;
    std::size_t span_ = 0;
    std::array<Values, 3> values_{};
};

glm::dvec3 xyz(const glm::dvec4& pole) {
    return {pole.x, pole.y, pole.z};
}

Jet<glm::dvec3> spline_at(const SurfaceCurve& curve, double t) {
    const Basis basis{curve.along, t};
    Jet<glm::dvec4> sum;
    for (std::uint32_t i = 0; i < basis.count(); ++i) {
        const glm::dvec4 pole = curve.poles[basis.first() + i];
        sum.at += basis.at(i) * pole;
        sum.first += basis.first_derivative(i) * pole;
        sum.second += basis.second_derivative(i) * pole;
    }
    Jet<glm::dvec3> result;
    result.at = xyz(sum.at) / sum.at.w;
    result.first = (xyz(sum.first) - result.at * sum.first.w) / sum.at.w;
    result.second =
        (xyz(sum.second) - 2.0 * result.first * sum.first.w - result.at * sum.second.w) / sum.at.w;
    return result;
}

Jet<glm::dvec3> curve_at(const SurfaceCurve& curve, double t) {
    switch (curve.kind) {
    case SurfaceCurve::Kind::line:
        return {.at = curve.point + t * curve.u, .first = curve.u};
    case SurfaceCurve::Kind::ellipse: {
        const double c = std::cos(t), s = std::sin(t);
        const glm::dvec3 out = c * curve.u + s * curve.v;
        return {.at = curve.point + out, .first = c * curve.v - s * curve.u, .second = -out};
    }
    case SurfaceCurve::Kind::spline:
        break;
    }
    return spline_at(curve, t);
}

/// Second derivatives of a surface by its parameters.
struct SecondDerivatives {
    glm::dvec3 uu{0}, uv{0}, vv{0};
};

SecondDerivatives revolve(const SurfaceShape& shape, glm::dvec2 at, SurfacePoint& point) {
    const double c = std::cos(at.x), s = std::sin(at.x);
    const auto turned = [&](const glm::dvec3& v) {
        const glm::dvec3 along = glm::dot(v, shape.axis) * shape.axis;
        return along + c * (v - along) + s * glm::cross(shape.axis, v);
    };
    Jet<glm::dvec3> curve = curve_at(shape.curve, at.y);
    const glm::dvec3 out = turned(curve.at - shape.point);
    point.at = shape.point + out;
    point.u = glm::cross(shape.axis, out);
    point.v = turned(curve.first);
    return {.uu = glm::cross(shape.axis, point.u),
            .uv = glm::cross(shape.axis, point.v),
            .vv = turned(curve.second)};
}

SecondDerivatives extrude(const SurfaceShape& shape, glm::dvec2 at, SurfacePoint& point) {
    const Jet<glm::dvec3> curve = curve_at(shape.curve, at.x);
    point.at = curve.at + at.y * shape.axis;
    point.u = curve.first;
    point.v = shape.axis;
    return {.uu = curve.second};
}

SecondDerivatives net_at(const SurfaceShape& shape, glm::dvec2 at, SurfacePoint& point) {
    const Basis u{shape.along_u, at.x}, v{shape.along_v, at.y};
    const std::size_t row = shape.along_v.poles();
    glm::dvec4 s{0}, su{0}, sv{0}, suu{0}, suv{0}, svv{0};
    for (std::uint32_t i = 0; i < u.count(); ++i) {
        Jet<glm::dvec4> sum;
        const glm::dvec4* poles = &shape.poles[(u.first() + i) * row + v.first()];
        for (std::uint32_t j = 0; j < v.count(); ++j) {
            sum.at += v.at(j) * poles[j];
            sum.first += v.first_derivative(j) * poles[j];
            sum.second += v.second_derivative(j) * poles[j];
        }
        s += u.at(i) * sum.at;
        su += u.first_derivative(i) * sum.at;
        sv += u.at(i) * sum.first;
        suu += u.second_derivative(i) * sum.at;
        suv += u.first_derivative(i) * sum.first;
        svv += u.at(i) * sum.second;
    }
    point.at = xyz(s) / s.w;
    point.u = (xyz(su) - point.at * su.w) / s.w;
    point.v = (xyz(sv) - point.at * sv.w) / s.w;
    return {.uu = (xyz(suu) - 2.0 * point.u * su.w - point.at * suu.w) / s.w,
            .uv = (xyz(suv) - point.u * sv.w - point.v * su.w - point.at * suv.w) / s.w,
            .vv = (xyz(svv) - 2.0 * point.v * sv.w - point.at * svv.w) / s.w};
}

SecondDerivatives base_at(const SurfaceShape& shape, glm::dvec2 at, SurfacePoint& point) {
    switch (shape.kind) {
    case SurfaceShape::Kind::revolution:
        return revolve(shape, at, point);
    case SurfaceShape::Kind::extrusion:
        return extrude(shape, at, point);
    case SurfaceShape::Kind::spline:
        break;
    }
    return net_at(shape, at, point);
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool are_sound(std::span<const glm::dvec4> poles) {
    return std::ranges::all_of(poles, [](const glm::dvec4& pole) {
        return is_finite(xyz(pole)) && pole.w > 0 && std::isfinite(pole.w);
    });
}

bool is_sound(const SplineDirection& along) {
    const std::vector<double>& knots = along.knots;
    return along.degree >= 1 && along.degree <= SplineDirection::most_degree &&
           knots.size() >= 2 * (std::size_t{along.degree} + 1) &&
           knots.size() < KnownSurfaces::none &&
           std::ranges::all_of(knots, [](double knot) { return std::isfinite(knot); }) &&
           std::ranges::is_sorted(knots) && knots[along.degree] < knots[along.poles()];
}

bool is_sound(const SurfaceCurve& curve) {
    if (curve.kind == SurfaceCurve::Kind::spline)
        return is_sound(curve.along) && curve.poles.size() == curve.along.poles() &&
               are_sound(curve.poles);
    return curve.kind < SurfaceCurve::Kind::spline && is_finite(curve.point) &&
           is_finite(curve.u) && is_finite(curve.v);
}

bool is_sound(const SurfaceShape& shape) {
    if (!std::isfinite(shape.offset)) return false;
    if (shape.kind == SurfaceShape::Kind::spline)
        return is_sound(shape.along_u) && is_sound(shape.along_v) &&
               shape.poles.size() / shape.along_u.poles() == shape.along_v.poles() &&
               shape.poles.size() % shape.along_u.poles() == 0 && are_sound(shape.poles);
    return shape.kind < SurfaceShape::Kind::spline && is_finite(shape.point) &&
           is_finite(shape.axis) && is_sound(shape.curve);
}

} // namespace

SurfacePoint evaluate(const SurfaceShape& shape, glm::dvec2 parameters) {
    SurfacePoint point;
    const SecondDerivatives second = base_at(shape, parameters, point);
    const glm::dvec3 across = glm::cross(point.u, point.v);
    const double area = glm::length(across);
    const double size = glm::dot(point.u, point.u) + glm::dot(point.v, point.v);
    constexpr double smallest = 1e-9; // of a pole
    if (!(area > smallest * size)) return point;
    point.normal = across / area;
    const auto turning = [&](const glm::dvec3& change) {
        return (change - point.normal * glm::dot(point.normal, change)) / area;
    };
    point.normal_u = turning(glm::cross(second.uu, point.v) + glm::cross(point.u, second.uv));
    point.normal_v = turning(glm::cross(second.uv, point.v) + glm::cross(point.u, second.vv));
    point.at += shape.offset * point.normal;
    point.u += shape.offset * point.normal_u;
    point.v += shape.offset * point.normal_v;
    return point;
}

bool is_sound(const KnownSurfaces& known, std::size_t triangles) {
    const auto is_placed = [&](const PlacedSurface& surface) {
        const glm::dmat4x3& m = surface.model_from_shape;
        return surface.shape < known.shapes.size() && is_finite(m[0]) && is_finite(m[1]) &&
               is_finite(m[2]) && is_finite(m[3]);
    };
    const auto is_number = [&](std::uint32_t surface) {
        return surface == KnownSurfaces::none || surface < known.surfaces.size();
    };
    const auto is_corner = [](const glm::dvec2& at) {
        return std::isfinite(at.x) && std::isfinite(at.y);
    };
    return known.parameters.size() == known.of_triangle.size() &&
           (known.empty() || known.of_triangle.size() == triangles) &&
           std::ranges::all_of(known.shapes,
                               [](const SurfaceShape& shape) { return is_sound(shape); }) &&
           std::ranges::all_of(known.surfaces, is_placed) &&
           std::ranges::all_of(known.of_triangle, is_number) &&
           std::ranges::all_of(known.parameters, [&](const std::array<glm::dvec2, 3>& corners) {
               return std::ranges::all_of(corners, is_corner);
           });
}

} // namespace lineatlas
