#pragma once

#include <string>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// True if any of the lines lies at least partly between the camera's planes. It may be hidden, and
/// a candidate need not be a silhouette from there.
bool any_in_view(const LineSet& lines, const Camera& camera);

/// Why a drawing by that camera shows none of the lines, in one line for people. `kinds`: those
/// that they were extracted with.
std::string why_no_line(const LineSet& lines, LineKindMask kinds, const Camera& camera);

} // namespace lineatlas
