#pragma once

#include <span>
#include <vector>

#include "compute/stages/stages.hpp"
#include "lineatlas/lines.hpp"
#include "segment_table.h"
#include "table_order.hpp"

namespace lineatlas {

/// Reads the parts of a chunk's segments that have the background on one side, and appends the
/// parts of visible intervals that lie on them. `intervals`: those of the same segments, in the
/// frame's `order`. Segments of the line set are numbered from `first_segment` on.
void add_outline_parts(compute::Device& device, const compute::OutlineTable& table,
                       std::span<const Interval> intervals, const TableOrder& order,
                       std::uint32_t first_segment, std::uint32_t segment_count,
                       std::vector<OutlinePart>& result);

} // namespace lineatlas
