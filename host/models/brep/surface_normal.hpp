#pragma once

#include <optional>

#include <Geom_Surface.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

namespace lineatlas::brep {

/// The unit normal of a surface, in the direction given by its parameters. Nothing if there is
/// none, as at the tip of a cone, or where parameters meet, as at the pole of a sphere.
std::optional<gp_Vec> normal_of(const Geom_Surface& surface, const gp_Pnt2d& at);

/// The normal at a point where parameters meet, as at a pole or a tip, on the side of `towards`, a
/// place beside the point.
std::optional<gp_Vec> normal_beside(const Geom_Surface& surface, const gp_Pnt2d& at,
                                    const gp_Pnt2d& towards);

} // namespace lineatlas::brep
