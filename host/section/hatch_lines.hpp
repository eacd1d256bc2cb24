#pragma once

#include <utility>
#include <vector>

#include "cut_faces.hpp"

namespace lineatlas {

/// Lines across the solid area of a face, from outline to outline, `spacing` apart. `angle`: in
/// degrees from the plane's u axis towards v.
std::vector<std::pair<glm::dvec2, glm::dvec2>> hatch_lines(const CutFace& face, double spacing,
                                                           double angle);

/// The hatching angle of a part, by its number. It differs from the angles of the parts before it.
double hatch_angle(double first, std::size_t number);

} // namespace lineatlas
