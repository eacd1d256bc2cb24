#pragma once

#include <string>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// True if any of the lines lies at least partly between the camera's planes. That line may be
/// hidden, or be a candidate that is no silhouette in this view.
bool any_in_view(const LineSet& lines, const Camera& camera);

/// The reason why a drawing by that camera shows none of the lines, in one line for people. kinds:
/// the kinds that were extracted.
std::string why_no_line(const LineSet& lines, LineKindMask kinds, const Camera& camera);

} // namespace lineatlas
