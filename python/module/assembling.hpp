#pragma once

#include <cstdint>

#include "lineatlas/lines.hpp"

namespace lineatlas::python {

/// Positions, triangles and groups of a part behind those of a mesh.
void append(Mesh& mesh, const Mesh& part);

/// What lines refer to of their mesh stands behind so many positions and triangles.
void shift_sources(LineSet& lines, std::uint32_t vertices, std::uint32_t triangles);

} // namespace lineatlas::python
