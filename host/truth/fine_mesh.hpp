#pragma once

#include <cstdint>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The number of parts into which fine_mesh() should divide edges: ten, fewer for large meshes, and
/// one if no triangle has a surface.
std::uint32_t fine_parts(const Mesh& mesh);

/// The model in triangles that lie closer to its surfaces (Mesh::surfaces). Edges of triangles with
/// a surface are divided into `parts`, at places on the file's own curves and surfaces, so chords
/// are off by a factor of parts squared less. Positions of the mesh keep their numbers.
Mesh fine_mesh(const Mesh& mesh, std::uint32_t parts);

} // namespace lineatlas
