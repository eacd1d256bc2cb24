#pragma once

#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::viewer {

/// The model without lines whose paths, seen from the side, would be shorter than `pixels` pixels
/// of the camera's picture. Faces, and edges that may become silhouettes, stay.
LineSet long_lines(const LineSet& lines, const Camera& camera, float pixels);

} // namespace lineatlas::viewer
