#pragma once

#include "plane_cut.hpp"
#include "plane_frame.hpp"

namespace lineatlas {

/// Gives steps of a cut through known surfaces their curves, where these are circles or ellipses:
/// puts the steps' places onto the curves and adds edges (KnownEdge::Kind::wire) along them, which
/// the file calls as it does the surface.
void follow_curves(PlaneCut& cut, const PlaneFrame& plane);

} // namespace lineatlas
