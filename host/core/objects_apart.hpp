#pragma once

#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The objects of a line set that has some, each by itself: its indices count from 0.
std::vector<LineSet> objects_apart(const LineSet& lines);

} // namespace lineatlas
