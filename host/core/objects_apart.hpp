#pragma once

#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Every object of a line set by itself, with indices from 0. The line set must have objects.
std::vector<LineSet> objects_apart(const LineSet& lines);

} // namespace lineatlas
