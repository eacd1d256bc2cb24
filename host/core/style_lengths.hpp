#pragma once

#include "lineatlas/style.hpp"

namespace lineatlas {

/// Multiplies every length of a style by a factor, for a picture whose sides have `factor` times as
/// many pixels. The lengths are then right for that picture, and Style::made_for is 0.
void multiply_lengths(Style& style, float factor);

/// A style for a mesh about an origin of its own (LoadedMesh::origin). A focus at a point of the
/// model is given in the file's coordinates.
Style about_origin(Style style, glm::dvec3 origin);

} // namespace lineatlas
