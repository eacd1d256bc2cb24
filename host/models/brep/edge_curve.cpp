#include "edge_curve.hpp"

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
    default:
        return std::nullopt;
    }
}

} // namespace lineatlas::brep
