#pragma once

#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Orders and turns the paths of each group (one kind, visible or hidden; groups stand together) so
/// that the pen travels little between them, joins those whose ends meet within `gap` pixels, and
/// closes what then comes back to its start.
PenTravel order_for_plotter(std::vector<VectorPath>& paths, double gap = 0.1);

} // namespace lineatlas
