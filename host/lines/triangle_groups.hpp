#pragma once

#include <cstdint>
#include <vector>

#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// The colours of groups, and which one each triangle has.
void add_colors(const std::vector<MeshGroup>& groups,
                const std::vector<std::uint32_t>& triangle_group, LineSet& result);

/// Materials as numbers: triangles of one are one surface where they meet in a plane. What has no
/// material is of its object. `objects`: of objects_of(), where they count.
std::vector<std::uint32_t> materials_of(const std::vector<MeshGroup>& groups,
                                        const WeldedMesh& mesh,
                                        const std::vector<std::uint32_t>& objects);

/// Of every triangle; empty where all of the mesh is one.
std::vector<std::uint32_t> objects_of(const WeldedMesh& mesh);

} // namespace lineatlas
