#pragma once

#include <cstdint>

#include "lineatlas/lines.hpp"

namespace lineatlas::python {

/// Appends the positions, triangles and groups of a part to a mesh.
void append(Mesh& mesh, const Mesh& part);

/// Adapts the lines of a part to a mesh in which `vertices` positions and `triangles` triangles
/// precede the part's own.
void shift_sources(LineSet& lines, std::uint32_t vertices, std::uint32_t triangles);

} // namespace lineatlas::python
