#pragma once

#include <string>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Whether any of the lines lies, if only in part, between the camera's planes. What hides it is
/// not looked at, nor whether a silhouette is one from there.
bool any_in_view(const LineSet& lines, const Camera& camera);

/// Why a drawing by that camera shows none of the lines, in one line for people. `kinds`: those
/// that they were extracted with.
std::string why_no_line(const LineSet& lines, LineKindMask kinds, const Camera& camera);

} // namespace lineatlas
