#include "degenerate_torus.hpp"

#include <cmath>

#include <Standard_Failure.hxx>
#include <StepGeom_Axis1Placement.hxx>
#include <StepGeom_Axis2Placement.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Circle.hxx>
#include <StepGeom_DegenerateToroidalSurface.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_HArray1OfTrimmingSelect.hxx>
#include <StepGeom_SurfaceOfRevolution.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepGeom_TrimmingSelect.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TCollection_HAsciiString.hxx>
#include <gp_Ax2.hxx>
#include <gp_XYZ.hxx>

namespace lineatlas::brep {
namespace {

Handle(TCollection_HAsciiString) no_name() {
    return new TCollection_HAsciiString;
}

gp_XYZ read(const StepGeom_CartesianPoint& point) {
    return {point.CoordinatesValue(1), point.CoordinatesValue(2), point.CoordinatesValue(3)};
}

gp_Dir read(const StepGeom_Direction& direction) {
    return {direction.DirectionRatiosValue(1), direction.DirectionRatiosValue(2),
            direction.DirectionRatiosValue(3)};
}

bool is_whole(bool given, const Handle(StepGeom_Direction) & direction) {
    return !given || (!direction.IsNull() && direction->NbDirectionRatios() == 3);
}

/// Whether a damaged file has all of a placement.
bool is_whole(const Handle(StepGeom_Axis2Placement3d) & placement) {
    return !placement.IsNull() && !placement->Location().IsNull() &&
           placement->Location()->NbCoordinates() == 3 &&
           is_whole(placement->HasAxis(), placement->Axis()) &&
           is_whole(placement->HasRefDirection(), placement->RefDirection());
}

/// In the file's own units. What is not given is as the standard says: along z, and any x.
gp_Ax2 read(const StepGeom_Axis2Placement3d& placement) {
    const gp_Pnt origin{read(*placement.Location())};
    const gp_Dir z = placement.HasAxis() ? read(*placement.Axis()) : gp_Dir{0, 0, 1};
    if (!placement.HasRefDirection()) return {origin, z};
    return {origin, z, read(*placement.RefDirection())};
}

Handle(StepGeom_CartesianPoint) point_at(const gp_XYZ& at) {
    Handle(StepGeom_CartesianPoint) point = new StepGeom_CartesianPoint;
    point->Init3D(no_name(), at.X(), at.Y(), at.Z());
    return point;
}

Handle(StepGeom_Direction) direction_along(const gp_Dir& along) {
    Handle(TColStd_HArray1OfReal) ratios = new TColStd_HArray1OfReal(1, 3);
    for (int axis = 1; axis <= 3; ++axis) ratios->SetValue(axis, along.Coord(axis));
    Handle(StepGeom_Direction) direction = new StepGeom_Direction;
    direction->Init(no_name(), ratios);
    return direction;
}

Handle(StepGeom_HArray1OfTrimmingSelect) trim_at(const gp_XYZ& at) {
    StepGeom_TrimmingSelect trim;
    trim.SetValue(point_at(at));
    Handle(StepGeom_HArray1OfTrimmingSelect) trims = new StepGeom_HArray1OfTrimmingSelect(1, 1);
    trims->SetValue(1, trim);
    return trims;
}

/// The arc of the torus's circle that makes its part, from axis to axis.
Handle(StepGeom_Curve)
    arc_of(const StepGeom_DegenerateToroidalSurface& torus, const gp_Ax2& place) {
    const gp_XYZ x = place.XDirection().XYZ(), z = place.Direction().XYZ();
    const gp_XYZ origin = place.Location().XYZ(), middle = origin + torus.MajorRadius() * x;
    Handle(StepGeom_Axis2Placement3d) about = new StepGeom_Axis2Placement3d;
    about->Init(no_name(), point_at(middle), true, direction_along(place.YDirection().Reversed()),
                true, direction_along(place.XDirection()));
    StepGeom_Axis2Placement placement;
    placement.SetValue(about);
    Handle(StepGeom_Circle) circle = new StepGeom_Circle;
    circle->Init(no_name(), placement, torus.MinorRadius());
    const double half = std::sqrt(torus.MinorRadius() * torus.MinorRadius() -
                                  torus.MajorRadius() * torus.MajorRadius());
    const double start = torus.SelectOuter() ? -half : half;
    Handle(StepGeom_TrimmedCurve) arc = new StepGeom_TrimmedCurve;
    arc->Init(no_name(), circle, trim_at(origin + start * z), trim_at(origin - start * z), true,
              StepGeom_tpCartesian);
    return arc;
}

Handle(StepGeom_Surface) swept(const StepGeom_DegenerateToroidalSurface& torus) {
    const gp_Ax2 place = read(*torus.Position());
    Handle(StepGeom_Axis1Placement) axis = new StepGeom_Axis1Placement;
    axis->Init(no_name(), point_at(place.Location().XYZ()), true,
               direction_along(place.Direction()));
    Handle(StepGeom_SurfaceOfRevolution) surface = new StepGeom_SurfaceOfRevolution;
    surface->Init(no_name(), arc_of(torus, place), axis);
    return surface;
}

} // namespace

void sweep_degenerate_tori(const StepData_StepModel& model) {
    for (int i = 1; i <= model.NbEntities(); ++i) {
        const auto face = Handle(StepShape_FaceSurface)::DownCast(model.Value(i));
        if (face.IsNull()) continue;
        const auto torus =
            Handle(StepGeom_DegenerateToroidalSurface)::DownCast(face->FaceGeometry());
        if (torus.IsNull() || !is_whole(torus->Position())) continue;
        if (torus->MinorRadius() <= torus->MajorRadius() || torus->MajorRadius() <= 0) continue;
        try {
            face->SetFaceGeometry(swept(*torus));
        } catch (const Standard_Failure&) { // directions without length: as Open CASCADE reads it
        }
    }
}

} // namespace lineatlas::brep
