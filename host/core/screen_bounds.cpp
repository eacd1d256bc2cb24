#include "screen_bounds.hpp"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace lineatlas {

TexelRectangle screen_bounds(const Bounds& bounds, const glm::mat4& clip_from_world,
                             glm::ivec2 size, int margin, int tile) {
    const glm::vec2 extent{size};
    glm::vec2 low{extent}, high{0};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 upper{(corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0};
        const glm::vec4 clip =
            clip_from_world * glm::vec4{glm::mix(bounds.min, bounds.max, upper), 1};
        if (!(clip.w > 0)) return {{0, 0}, size};
        const glm::vec2 window = (glm::vec2{clip} / clip.w + 1.0F) * 0.5F * extent;
        low = glm::min(low, window);
        high = glm::max(high, window);
    }
    // Cut before the conversion, because a far corner may lie beyond the range of int.
    const float reach = static_cast<float>(margin);
    const glm::ivec2 first{glm::clamp(glm::floor(low - reach), glm::vec2{0}, extent)};
    const glm::ivec2 last{glm::clamp(glm::ceil(high + reach), glm::vec2{0}, extent)};
    if (first.x >= last.x || first.y >= last.y) return {};
    return {first / tile * tile, glm::min((last + (tile - 1)) / tile * tile, size)};
}

} // namespace lineatlas
