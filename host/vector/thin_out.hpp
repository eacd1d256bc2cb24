#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Marks as VectorPath::thinned what is drawn in vain where lines are dense (§4.5, after Grabli,
/// Durand and Sillion 2004): paths take their place in the order of their priority, and a part of
/// one is thinned where those before it reach Style::density about it, or Style::hidden_density
/// if it is hidden. Outlines come first, then the kinds by Density::priority, then longer paths.
/// Divides paths where that begins and ends; no piece and no gap is shorter than 12 pixels.
///
/// In time in proportion to the length of all paths. `picture`: its size in pixels.
std::vector<VectorPath> thin_out(std::vector<VectorPath> paths, const Style& style,
                                 glm::dvec2 picture);

} // namespace lineatlas
