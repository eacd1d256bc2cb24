#pragma once

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Throws UsageError unless every index of the line set is in range, every vertex is finite, and
/// the sizes of the tables fit each other: kernels and GL read the tables without checks. Takes one
/// pass over the tables.
void check_lines(const LineSet& lines);

} // namespace lineatlas
