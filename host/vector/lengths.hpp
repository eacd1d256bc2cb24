#pragma once

#include <span>

#include "halos.hpp"
#include "lineatlas/style.hpp"
#include "strips.hpp"

namespace lineatlas {

/// A stroke between two changes of visibility that is shorter than this, in pixels, is chance,
/// because samples are farther apart.
constexpr double crumb_of_samples = 1;

/// Changes the visible strokes of a strip as the kernel `filter` does: closes short holes, drops
/// short strokes, lets strokes overshoot or fall short of their ends, and cuts `cuts` (sorted) into
/// them. crumb: strokes between two changes of visibility that are shorter than this, in pixels,
/// are always dropped.
void filter_lengths(Strip& strip, const StrokeFilter& filter, std::span<const Cut> cuts,
                    double crumb);

} // namespace lineatlas
