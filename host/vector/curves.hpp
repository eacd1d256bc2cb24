#pragma once

#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Finds the parts of paths that run along the file's own circles and ellipses
/// (Mesh::edge_curves), and puts ends of paths, which lie on chords, onto them. A part whose points
/// are not on its curve, as of an object that has moved since it was read, has none; neither has
/// one that is seen so flat or is so small that half a pixel holds it.
void find_curves(const Mesh& mesh, const Camera& camera, std::vector<VectorPath>& paths);

} // namespace lineatlas
