#pragma once

#include <cstddef>

#include <glm/vec2.hpp>

#include "lineatlas/lines.hpp"
#include "pieces.hpp"

namespace lineatlas {

/// Lets lines that pass behind others end exactly at them: an end where visibility changes moves to
/// where a nearer visible line crosses, if one does so within `reach` pixels, else to a vertex of
/// its own segment within reach that another visible line ends at. The hidden piece that starts
/// there moves along. Exact visibility has its ends on triangles: only at silhouettes that lie on
/// known surfaces, a little beyond the triangles, they move. Returns how many ends met a line.
std::size_t meet_junctions(const LineSet& lines, glm::dvec2 picture, Pieces& pieces,
                           double reach = 1.25);

} // namespace lineatlas
