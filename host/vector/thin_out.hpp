#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Marks parts of paths as VectorPath::thinned where lines are too dense (§4.5, after Grabli,
/// Durand and Sillion 2004). Paths take their places in the order of their priority. A part is
/// thinned where earlier paths reach Style::density about it, or Style::hidden_density if it is
/// hidden. Outlines come first, then the kinds by Density::priority, then longer paths. Divides
/// paths where thinning begins and ends. No part and no gap is shorter than 12 pixels.
///
/// The time is proportional to the length of all paths. `picture`: its size in pixels.
std::vector<VectorPath> thin_out(std::vector<VectorPath> paths, const Style& style,
                                 glm::dvec2 picture);

} // namespace lineatlas
