#pragma once

#include <span>

#include "runs.hpp"
#include "style_numbers.h"

namespace lineatlas::test::oracles {

struct FilterInput {
    FrameTables frame;
    std::span<const std::uint8_t> alpha; ///< before it is changed
    std::uint32_t capacity;
    StrokeFilter filter;
    std::span<const Run> runs;
    std::span<const RunCuts> cuts; ///< empty: no gaps
};

/// Filters whole paths like `filter`, but with all intervals of a path at a time, in lists that
/// grow. alpha: the memory of FilterInput::alpha, or other. Writes nothing to `filtered` if it is
/// too small. Returns the record of what it wrote.
FrameRecord filter(const FilterInput& input, std::span<std::uint8_t> alpha, std::span<Run> filtered,
                   const FrameRecord& record);

} // namespace lineatlas::test::oracles
