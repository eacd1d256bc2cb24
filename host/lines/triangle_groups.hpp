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

/// The number of each triangle's body: its material, or without one its part, because bodies of an
/// assembly that end in one plane are each drawn. `materials`: materials_of(). `part_of_vertex`:
/// MeshParts::of_vertex.
std::vector<std::uint32_t> bodies_of(const std::vector<MeshGroup>& groups, const WeldedMesh& mesh,
                                     const std::vector<std::uint32_t>& materials,
                                     const std::vector<std::uint32_t>& part_of_vertex);

/// The object of every triangle; empty if the whole mesh is one object.
std::vector<std::uint32_t> objects_of(const WeldedMesh& mesh);

} // namespace lineatlas
