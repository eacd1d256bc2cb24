#pragma once

#include <span>

#include "halos.hpp"
#include "lineatlas/style.hpp"
#include "strips.hpp"

namespace lineatlas {

/// Changes what is visible of a strip as the kernel `filter` does: closes short holes, drops short
/// strokes, lets them overshoot or fall short of their ends, and cuts `cuts` (sorted) into them.
void filter_lengths(Strip& strip, const StrokeFilter& filter, std::span<const Cut> cuts);

} // namespace lineatlas
