#include "face_surface.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>

namespace lineatlas::brep {

namespace {

glm::dvec3 vec(const gp_XYZ& v) {
    return {v.X(), v.Y(), v.Z()};
}

glm::dvec4 pole_of(const gp_Pnt& at, double weight) {
    return {weight * vec(at.XYZ()), weight};
}

SplineDirection along(int degree, const TColStd_Array1OfReal& knots) {
    SplineDirection result{.degree = static_cast<std::uint32_t>(degree), .knots = {}};
    for (const double knot : knots) result.knots.push_back(knot);
    return result;
}

SurfaceCurve ellipse(const gp_Ax2& frame, double major, double minor) {
    return {.kind = SurfaceCurve::Kind::ellipse,
            .point = vec(frame.Location().XYZ()),
            .u = major * vec(frame.XDirection().XYZ()),
            .v = minor * vec(frame.YDirection().XYZ())};
}

SurfaceCurve spline(Handle(Geom_BSplineCurve) curve) {
    if (curve->IsPeriodic()) {
        curve = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
        curve->SetNotPeriodic();
    }
    SurfaceCurve result{.kind = SurfaceCurve::Kind::spline,
                        .along = along(curve->Degree(), curve->KnotSequence())};
    for (int i = 1; i <= curve->NbPoles(); ++i)
        result.poles.push_back(pole_of(curve->Pole(i), curve->Weight(i)));
    return result;
}

std::optional<SurfaceCurve> curve_of(const Handle(Geom_Curve) & curve) {
    if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
        return curve_of(trimmed->BasisCurve());
    if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull())
        return SurfaceCurve{.point = vec(line->Position().Location().XYZ()),
                            .u = vec(line->Position().Direction().XYZ())};
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull())
        return ellipse(circle->Position(), circle->Radius(), circle->Radius());
    if (const auto one = Handle(Geom_Ellipse)::DownCast(curve); !one.IsNull())
        return ellipse(one->Position(), one->MajorRadius(), one->MinorRadius());
    if (const auto one = Handle(Geom_BSplineCurve)::DownCast(curve); !one.IsNull())
        return spline(one);
    if (const auto one = Handle(Geom_BezierCurve)::DownCast(curve); !one.IsNull())
        return spline(GeomConvert::CurveToBSplineCurve(one));
    return std::nullopt;
}

/// A curve turned about the axis of a frame, from its x to its y. The frame may have either hand.
SurfaceShape revolution(const gp_Ax3& frame, const SurfaceCurve& curve) {
    return {.kind = SurfaceShape::Kind::revolution,
            .point = vec(frame.Location().XYZ()),
            .axis = glm::cross(vec(frame.XDirection().XYZ()), vec(frame.YDirection().XYZ())),
            .curve = curve};
}

/// A cylinder or a cone with this half angle.
SurfaceShape cone(const gp_Ax3& frame, double radius, double angle) {
    const glm::dvec3 x = vec(frame.XDirection().XYZ()), z = vec(frame.Direction().XYZ());
    return revolution(frame, {.point = vec(frame.Location().XYZ()) + radius * x,
                              .u = std::sin(angle) * x + std::cos(angle) * z});
}

/// A sphere or a torus.
SurfaceShape ring(const gp_Ax3& frame, double major, double minor) {
    const glm::dvec3 x = vec(frame.XDirection().XYZ()), z = vec(frame.Direction().XYZ());
    return revolution(frame, {.kind = SurfaceCurve::Kind::ellipse,
                              .point = vec(frame.Location().XYZ()) + major * x,
                              .u = minor * x,
                              .v = minor * z});
}

SurfaceShape net(Handle(Geom_BSplineSurface) surface) {
    if (surface->IsUPeriodic() || surface->IsVPeriodic()) {
        surface = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
        if (surface->IsUPeriodic()) surface->SetUNotPeriodic();
        if (surface->IsVPeriodic()) surface->SetVNotPeriodic();
    }
    // Open CASCADE leaves the weights of a polynomial net that was periodic at zero.
    const bool weighted = surface->IsURational() || surface->IsVRational();
    SurfaceShape result{.kind = SurfaceShape::Kind::spline,
                        .along_u = along(surface->UDegree(), surface->UKnotSequence()),
                        .along_v = along(surface->VDegree(), surface->VKnotSequence())};
    for (int i = 1; i <= surface->NbUPoles(); ++i)
        for (int j = 1; j <= surface->NbVPoles(); ++j)
            result.poles.push_back(
                pole_of(surface->Pole(i, j), weighted ? surface->Weight(i, j) : 1));
    return result;
}

std::optional<SurfaceShape> shape_of(const Handle(Geom_Surface) & surface) {
    if (const auto one = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !one.IsNull())
        return shape_of(one->BasisSurface());
    if (const auto one = Handle(Geom_Plane)::DownCast(surface); !one.IsNull())
        return SurfaceShape{.kind = SurfaceShape::Kind::extrusion,
                            .axis = vec(one->Position().YDirection().XYZ()),
                            .curve = {.point = vec(one->Position().Location().XYZ()),
                                      .u = vec(one->Position().XDirection().XYZ())}};
    if (const auto one = Handle(Geom_CylindricalSurface)::DownCast(surface); !one.IsNull())
        return cone(one->Position(), one->Radius(), 0);
    if (const auto one = Handle(Geom_ConicalSurface)::DownCast(surface); !one.IsNull())
        return cone(one->Position(), one->RefRadius(), one->SemiAngle());
    if (const auto one = Handle(Geom_SphericalSurface)::DownCast(surface); !one.IsNull())
        return ring(one->Position(), 0, one->Radius());
    if (const auto one = Handle(Geom_ToroidalSurface)::DownCast(surface); !one.IsNull())
        return ring(one->Position(), one->MajorRadius(), one->MinorRadius());
    if (const auto one = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !one.IsNull()) {
        const std::optional<SurfaceCurve> curve = curve_of(one->BasisCurve());
        if (!curve) return std::nullopt;
        return SurfaceShape{.kind = SurfaceShape::Kind::revolution,
                            .point = vec(one->Axis().Location().XYZ()),
                            .axis = vec(one->Axis().Direction().XYZ()),
                            .curve = *curve};
    }
    if (const auto one = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !one.IsNull()) {
        const std::optional<SurfaceCurve> curve = curve_of(one->BasisCurve());
        if (!curve) return std::nullopt;
        return SurfaceShape{.kind = SurfaceShape::Kind::extrusion,
                            .axis = vec(one->Direction().XYZ()),
                            .curve = *curve};
    }
    if (const auto one = Handle(Geom_BSplineSurface)::DownCast(surface); !one.IsNull())
        return net(one);
    if (const auto one = Handle(Geom_BezierSurface)::DownCast(surface); !one.IsNull())
        return net(GeomConvert::SurfaceToBSplineSurface(one));
    if (const auto one = Handle(Geom_OffsetSurface)::DownCast(surface); !one.IsNull()) {
        std::optional<SurfaceShape> base = shape_of(one->BasisSurface());
        if (base) base->offset += one->Offset();
        return base;
    }
    return std::nullopt;
}

} // namespace

std::optional<SurfaceShape> surface_of(const TopoDS_Face& face) {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    return surface.IsNull() ? std::nullopt : shape_of(surface);
}

} // namespace lineatlas::brep
