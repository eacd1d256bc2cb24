#pragma once

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// Throws UsageError where a triangle or polyline has an index that no position has.
void check_indices(const Mesh& mesh);

/// Throws UsageError where there are groups and Mesh::triangle_group does not name one of them for
/// each triangle.
void check_groups(const Mesh& mesh);

} // namespace lineatlas
