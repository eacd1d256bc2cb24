#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

/// @file
/// The volume that a mesh encloses.
/// @code{.cpp}
/// if (const std::optional<double> volume = enclosed_volume(mesh)) std::cout << *volume << '\n';
/// @endcode

namespace lineatlas {

/// The volume that triangles enclose, in cubes of the unit of `positions`; negative if they are
/// turned inside out. Nothing unless the triangles are closed and turned alike: along every edge,
/// told by the positions of its ends, as many triangles go one way as the other. If bodies overlap,
/// each counts as a whole. Throws UsageError for an index out of range.
LINEATLAS_API std::optional<double> enclosed_volume(std::span<const glm::vec3> positions,
                                                    std::span<const glm::uvec3> triangles);

/// The volume that all triangles of a mesh enclose.
LINEATLAS_API std::optional<double> enclosed_volume(const Mesh& mesh);

} // namespace lineatlas
