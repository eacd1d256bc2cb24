#include "tiles.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace lineatlas {

std::vector<PictureTile> make_tiles(glm::ivec2 size, int tile_size) {
    std::vector<PictureTile> tiles;
    for (int top = size.y; top > 0; top -= tile_size) {
        const int bottom = std::max(top - tile_size, 0);
        for (int left = 0; left < size.x; left += tile_size) {
            const int right = std::min(left + tile_size, size.x);
            tiles.push_back({{left, bottom}, {right - left, top - bottom}});
        }
    }
    return tiles;
}

glm::vec4 tile_transform(const PictureTile& tile, glm::ivec2 size) {
    const glm::dvec2 part{tile.size};
    const glm::dvec2 middle = glm::dvec2{tile.low} + 0.5 * part;
    return {glm::dvec2{size} / part, (glm::dvec2{size} - 2.0 * middle) / part};
}

glm::mat4 tile_projection(const glm::mat4& clip_from_world, const PictureTile& tile,
                          glm::ivec2 size) {
    const glm::vec4 transform = tile_transform(tile, size);
    glm::mat4 tile_from_whole{1};
    tile_from_whole[0][0] = transform.x;
    tile_from_whole[1][1] = transform.y;
    tile_from_whole[3][0] = transform.z;
    tile_from_whole[3][1] = transform.w;
    return tile_from_whole * clip_from_world;
}

} // namespace lineatlas
