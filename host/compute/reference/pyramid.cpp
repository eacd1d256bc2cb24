#include "stages.hpp"

#include <algorithm>

namespace lineatlas::compute::reference {

void pyramid(std::span<const float> depth, glm::ivec2 depth_size, std::span<float> tiles) {
    const glm::ivec2 tile_count = tiles_for(depth_size);
    for (int i = 0; i < tile_count.x * tile_count.y; ++i) {
        const glm::ivec2 first = glm::ivec2{i % tile_count.x, i / tile_count.x} * LA_TILE;
        const glm::ivec2 end{std::min(first.x + LA_TILE, depth_size.x),
                             std::min(first.y + LA_TILE, depth_size.y)};
        float farthest = 0;
        for (int y = first.y; y < end.y; ++y) {
            for (int x = first.x; x < end.x; ++x) {
                const auto index = static_cast<std::size_t>(y) * depth_size.x + x;
                farthest = std::max(farthest, depth[index]);
            }
        }
        tiles[static_cast<std::size_t>(i)] = farthest;
    }
}

} // namespace lineatlas::compute::reference
