#pragma once

#include <cstddef>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "pieces.hpp"

namespace lineatlas {

/// Makes lines that pass behind others end exactly at them. An end where visibility changes moves
/// to the crossing with a nearer visible line, if there is one within `reach` pixels; otherwise to
/// a vertex of its own segment within reach at which another visible line ends. The hidden piece
/// that starts there moves along. Ends of exact visibility lie on triangles. They move only to
/// silhouettes on known surfaces, which lie a little beyond the triangles, and only if triangles of
/// the silhouette's own smooth surface hide the line there. Returns the number of ends that met a
/// line.
std::size_t meet_junctions(const LineSet& lines, const Camera& camera, Pieces& pieces,
                           double reach = 1.25);

} // namespace lineatlas
