#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/lines.hpp"
#include "pieces.hpp"
#include "strips.hpp"

namespace lineatlas {

/// A gap in a strip, in pixels from its start.
struct Cut {
    double from, to;
};

struct HaloOptions {
    double width = 0;     ///< from the middle of the nearer line to the end of the gap, pixels
    double tolerance = 0; ///< window depth times w by which a line must be nearer
};

/// The gaps of each strip, sorted, where nearer lines cross its visible parts. The kernel `halo`
/// finds the same.
std::vector<std::vector<Cut>> find_halos(const LineSet& lines, const Pieces& pieces,
                                         const std::vector<Strip>& strips, glm::dvec2 picture,
                                         const HaloOptions& options);

} // namespace lineatlas
