#pragma once

#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Orders and turns the paths of each group (one kind, visible or hidden; groups stand together) so
/// that the pen travels little between them. Joins paths whose ends meet within `gap` pixels, and
/// closes paths that then come back to their start.
PenTravel order_for_plotter(std::vector<VectorPath>& paths, double gap = 0.1);

} // namespace lineatlas
