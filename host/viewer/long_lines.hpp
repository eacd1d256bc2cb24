#pragma once

#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::viewer {

/// The model without lines whose paths, seen from the side, would be shorter than so many pixels of
/// the camera's picture. Its faces, and edges that may become silhouettes, stay.
LineSet long_lines(const LineSet& lines, const Camera& camera, float pixels);

} // namespace lineatlas::viewer
