#pragma once

#include "common/drawing.hpp"
#include "report.hpp"

namespace lineatlas::bench {

/// A bar chart of frame rates, a panel per scene with a scale of its own, with marks where the
/// paper's ratios to OGL would put each method.
Drawing chart(const Report& report);

} // namespace lineatlas::bench
