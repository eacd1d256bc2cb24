#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The volume that triangles enclose, in cubes of the unit of `positions`; negative where they are
/// turned inside out. Nothing unless they are closed and turned alike: along every edge, by the
/// places of its ends, as many triangles go one way as the other. Bodies that overlap count
/// each. Throws UsageError for an index that is out of range.
LINEATLAS_API std::optional<double> enclosed_volume(std::span<const glm::vec3> positions,
                                                    std::span<const glm::uvec3> triangles);

/// The same of all triangles of a mesh.
LINEATLAS_API std::optional<double> enclosed_volume(const Mesh& mesh);

} // namespace lineatlas
