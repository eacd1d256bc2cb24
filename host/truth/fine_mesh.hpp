#pragma once

#include <cstdint>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// How many parts fine_mesh() should divide edges into: ten, fewer of large meshes, and one where
/// no triangle has a surface.
std::uint32_t fine_parts(const Mesh& mesh);

/// The same model in triangles that lie closer to its surfaces (Mesh::surfaces): edges of triangles
/// that have one are divided into so many parts, with places on the file's own curves and surfaces,
/// and chords are off by the square of that less. Positions of the mesh keep their numbers.
Mesh fine_mesh(const Mesh& mesh, std::uint32_t parts);

} // namespace lineatlas
