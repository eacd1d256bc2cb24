#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// Texels from `low` up to `high`, which is not included.
struct TexelRectangle {
    glm::ivec2 low{0, 0}, high{0, 0};

    glm::ivec2 size() const { return high - low; }
};

/// The texels that a box covers in a picture of `size` texels, with `margin` texels around them.
/// They are grown to whole tiles of `tile` texels and cut to the picture. The result is the whole
/// picture if a corner of the box is behind the eye, and empty if the box lies beside the picture.
TexelRectangle screen_bounds(const Bounds& bounds, const glm::mat4& clip_from_world,
                             glm::ivec2 size, int margin, int tile);

} // namespace lineatlas
