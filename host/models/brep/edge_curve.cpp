#include "edge_curve.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Curve.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

namespace lineatlas::brep {

namespace {

EdgeCurve curve_in(const gp_Ax2& frame, double major, double minor) {
    const auto along = [](const gp_Dir& axis, double length) {
        return length * glm::dvec3{axis.X(), axis.Y(), axis.Z()};
    };
    const gp_Pnt center = frame.Location();
    return {.center = {center.X(), center.Y(), center.Z()},
            .u = along(frame.XDirection(), major),
            .v = along(frame.YDirection(), minor)};
}

/// The circle that a spline is a part of, if it is. Files exchanged as NURBS have such splines.
std::optional<EdgeCurve> circle_of(const GeomAdaptor_Curve& curve, double first, double last) {
    const auto at = [&](double share) {
        const gp_Pnt point = curve.Value(first + share * (last - first));
        return glm::dvec3{point.X(), point.Y(), point.Z()};
    };
    const glm::dvec3 start = at(0), to_a = at(0.3) - start, to_b = at(0.6) - start;
    const glm::dvec3 normal = glm::cross(to_a, to_b);
    const double squared = glm::dot(normal, normal);
    const double size = glm::dot(to_a, to_a) + glm::dot(to_b, to_b);
    constexpr double straight = 1e-6;
    if (!(squared > straight * size * size)) return std::nullopt;
    const glm::dvec3 out = (glm::cross(normal, to_a) * glm::dot(to_b, to_b) +
                            glm::cross(to_b, normal) * glm::dot(to_a, to_a)) /
                           (2 * squared); // from the start to the centre
    const double radius = glm::length(out);
    const glm::dvec3 axis = normal / std::sqrt(squared);
    constexpr int places = 32;
    constexpr double tolerance = 1e-7;
    for (int i = 0; i <= places; ++i) {
        const glm::dvec3 from_center = at(static_cast<double>(i) / places) - start - out;
        if (std::abs(glm::length(from_center) - radius) > tolerance * radius ||
            std::abs(glm::dot(from_center, axis)) > tolerance * radius)
            return std::nullopt;
    }
    return EdgeCurve{.center = start + out, .u = -out, .v = glm::cross(axis, -out)};
}

} // namespace

std::optional<EdgeCurve> curve_of(const TopoDS_Edge& edge) {
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) return std::nullopt;
    const GeomAdaptor_Curve adaptor(curve);
    switch (adaptor.GetType()) {
    case GeomAbs_Circle: {
        const gp_Circ circle = adaptor.Circle();
        return curve_in(circle.Position(), circle.Radius(), circle.Radius());
    }
    case GeomAbs_Ellipse: {
        const gp_Elips ellipse = adaptor.Ellipse();
        return curve_in(ellipse.Position(), ellipse.MajorRadius(), ellipse.MinorRadius());
    }
    case GeomAbs_BSplineCurve:
    case GeomAbs_BezierCurve:
        return circle_of(adaptor, first, last);
    default:
        return std::nullopt;
    }
}

} // namespace lineatlas::brep
