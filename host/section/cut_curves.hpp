#pragma once

#include "plane_cut.hpp"
#include "plane_frame.hpp"

namespace lineatlas {

/// Gives steps of a cut through known surfaces their curves: moves the places of the steps onto the
/// curves, and adds edges along them (KnownEdge::Kind::wire) with the file's name of the surface.
/// Circles and ellipses are known as such. All others are known by their places, whose edges stand
/// one after the other, as those of a file's spline do.
void follow_curves(PlaneCut& cut, const PlaneFrame& plane);

} // namespace lineatlas
