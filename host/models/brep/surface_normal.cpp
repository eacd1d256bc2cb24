#include "surface_normal.hpp"

#include <gp_Pnt.hxx>

namespace lineatlas::brep {

std::optional<gp_Vec> normal_of(const Geom_Surface& surface, const gp_Pnt2d& at) {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface.D1(at.X(), at.Y(), point, along_u, along_v);
    const gp_Vec normal = along_u.Crossed(along_v);
    constexpr double smallest = 1e-12;
    if (!(normal.Magnitude() > smallest)) return std::nullopt;
    return normal.Normalized();
}

} // namespace lineatlas::brep
