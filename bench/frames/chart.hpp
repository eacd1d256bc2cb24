#pragma once

#include "common/drawing.hpp"
#include "report.hpp"

namespace lineatlas::bench {

/// A bar chart of frame rates with one panel per scene. Each panel has a scale of its own. Marks
/// show where the paper's ratio to OGL would put each method.
Drawing chart(const Report& report);

} // namespace lineatlas::bench
