#pragma once

#include <cstdint>
#include <vector>

#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Adds the colours of groups, and the colour of each triangle.
void add_colors(const std::vector<MeshGroup>& groups,
                const std::vector<std::uint32_t>& triangle_group, LineSet& result);

/// The number of each triangle's material. Triangles of one material are one surface where they
/// meet in a plane. A triangle without a material has a number of its object. `objects`:
/// objects_of(), if they count.
std::vector<std::uint32_t> materials_of(const std::vector<MeshGroup>& groups,
                                        const WeldedMesh& mesh,
                                        const std::vector<std::uint32_t>& objects);

/// The object of every triangle; empty if the whole mesh is one object.
std::vector<std::uint32_t> objects_of(const WeldedMesh& mesh);

} // namespace lineatlas
