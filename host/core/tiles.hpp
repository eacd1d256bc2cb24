#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// A picture of `size` cut into tiles of at most `tile_size` pixels a side: rows from the top, each
/// from the left.
std::vector<PictureTile> make_tiles(glm::ivec2 size, int tile_size);

/// The map from the clip space of a picture to that of a tile: xy of a point is multiplied by the
/// first two numbers and moved by the last two times w. It is applied to points, not to the matrix.
/// So a vertex falls on the same place in every tile, to within the precision of floats.
glm::vec4 tile_transform(const PictureTile& tile, glm::ivec2 size);
constexpr glm::vec4 whole_picture{1, 1, 0, 0};

/// The projection to a tile of a picture.
glm::mat4 tile_projection(const glm::mat4& clip_from_world, const PictureTile& tile,
                          glm::ivec2 size);

} // namespace lineatlas
