#pragma once

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Throws UsageError unless every index of the line set is that of something in it, every vertex is
/// finite, and the tables have the sizes that belong together: what kernels and GL read without
/// looking. One pass over the tables.
void check_lines(const LineSet& lines);

} // namespace lineatlas
