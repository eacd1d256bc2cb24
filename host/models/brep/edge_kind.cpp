#include "edge_kind.hpp"

#include <cmath>
#include <numbers>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopTools_ListIteratorOfListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include "surface_normal.hpp"

namespace lineatlas::brep {

namespace {

/// A face beside an edge, with the edge's curve on the face's surface.
class Side {
  public:
    Side(const TopoDS_Edge& edge, const TopoDS_Face& face)
        : surface_(BRep_Tool::Surface(face)),
          curve_(BRep_Tool::CurveOnSurface(edge, face, first_, last_)),
          sign_(face.Orientation() == TopAbs_REVERSED ? -1 : 1) {}

    bool known() const { return !surface_.IsNull() && !curve_.IsNull(); }

    /// The face's outward normal at a share of the edge's length; nothing if it has none there.
    std::optional<gp_Vec> normal(double share) const {
        const auto normal = normal_of(*surface_, curve_->Value(first_ + share * (last_ - first_)));
        if (!normal) return std::nullopt;
        return *normal * sign_;
    }

  private:
    // The order matters, because the curve's range is set with the curve.
    double first_ = 0, last_ = 0;
    Handle(Geom_Surface) surface_;
    Handle(Geom2d_Curve) curve_;
    double sign_;
};

bool is_smooth(const TopoDS_Edge& edge, const TopoDS_Face& a, const TopoDS_Face& b) {
    constexpr int places = 5;
    constexpr double least_angle = std::numbers::pi / 180;
    const Side one{edge, a}, other{edge, b};
    if (!one.known() || !other.known()) return false;
    int compared = 0;
    for (int i = 0; i < places; ++i) {
        const double share = (i + 0.5) / places;
        const std::optional<gp_Vec> n = one.normal(share), m = other.normal(share);
        if (!n || !m) continue;
        if (n->Angle(*m) >= least_angle) return false;
        ++compared;
    }
    return compared > 0;
}

} // namespace

std::optional<KnownEdge::Kind> kind_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
    if (BRep_Tool::Degenerated(edge)) return std::nullopt;
    TopTools_ListOfShape distinct;
    for (const TopoDS_Shape& face : faces) {
        bool known = false;
        for (const TopoDS_Shape& other : distinct) known = known || other.IsSame(face);
        if (!known) distinct.Append(face);
    }
    const TopoDS_Face& first = TopoDS::Face(distinct.First());
    if (distinct.Extent() == 1) {
        return BRep_Tool::IsClosed(edge, first) ? KnownEdge::Kind::seam : KnownEdge::Kind::free;
    }
    if (distinct.Extent() > 2) return KnownEdge::Kind::sharp;
    return is_smooth(edge, first, TopoDS::Face(distinct.Last())) ? KnownEdge::Kind::smooth
                                                                 : KnownEdge::Kind::sharp;
}

} // namespace lineatlas::brep
