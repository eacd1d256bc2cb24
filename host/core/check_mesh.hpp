#pragma once

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// Throws UsageError if a triangle or polyline has an index without a position.
void check_indices(const Mesh& mesh);

/// Throws UsageError if there are groups but Mesh::triangle_group does not name one for each
/// triangle.
void check_groups(const Mesh& mesh);

} // namespace lineatlas
