#include "surface_normal.hpp"

#include <gp_Pnt.hxx>

namespace lineatlas::brep {

std::optional<gp_Vec> normal_of(const Geom_Surface& surface, const gp_Pnt2d& at) {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface.D1(at.X(), at.Y(), point, along_u, along_v);
    const gp_Vec normal = along_u.Crossed(along_v);
    // Tips in files are rounded, so some places lie on the other side of their tip.
    constexpr double smallest = 1e-7;
    const double size = along_u.SquareMagnitude() + along_v.SquareMagnitude();
    if (!(normal.Magnitude() > smallest * size) || !(size > 0)) return std::nullopt;
    return normal / normal.Magnitude();
}

std::optional<gp_Vec> normal_beside(const Geom_Surface& surface, const gp_Pnt2d& at,
                                    const gp_Pnt2d& towards) {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface.D1(at.X(), at.Y(), point, along_u, along_v);
    constexpr double beside = 1e-4;
    gp_XY place = towards.XY();
    // One parameter may have any value at this point. `towards` gives its value.
    if (along_u.SquareMagnitude() <= along_v.SquareMagnitude())
        place.SetY(at.Y() * (1 - beside) + towards.Y() * beside);
    else
        place.SetX(at.X() * (1 - beside) + towards.X() * beside);
    return normal_of(surface, place);
}

} // namespace lineatlas::brep
