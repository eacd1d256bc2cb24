#pragma once

#include "plane_cut.hpp"
#include "plane_frame.hpp"

namespace lineatlas {

/// Gives steps of a cut through known surfaces their curves, where these are circles or ellipses:
/// moves the places of the steps onto the curves, and adds edges along them (KnownEdge::Kind::wire)
/// with the file's name of the surface.
void follow_curves(PlaneCut& cut, const PlaneFrame& plane);

} // namespace lineatlas
