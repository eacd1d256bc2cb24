#include "stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace lineatlas::compute::reference {
namespace {

/// The box of a cluster on the screen, or what can be said without one.
struct ScreenBox {
    glm::vec3 low{std::numeric_limits<float>::infinity()}; ///< normalised device coordinates
    glm::vec3 high{-std::numeric_limits<float>::infinity()};
    bool outside = false;
    bool before_near = false; ///< the corners don't bound it on the screen
};

ScreenBox screen_box(const Cluster& cluster, const glm::mat4& m) {
    ScreenBox box;
    int outside = 63;
    for (int corner = 0; corner < 8; ++corner) {
        const float x = (corner & 1) != 0 ? cluster.high[0] : cluster.low[0];
        const float y = (corner & 2) != 0 ? cluster.high[1] : cluster.low[1];
        const float z = (corner & 4) != 0 ? cluster.high[2] : cluster.low[2];
        const glm::vec4 c = (m[0] * x + m[1] * y) + (m[2] * z + m[3]);
        outside &= (c.x < -c.w ? 1 : 0) | (c.x > c.w ? 2 : 0) | (c.y < -c.w ? 4 : 0) |
                   (c.y > c.w ? 8 : 0) | (c.z < -c.w ? 16 : 0) | (c.z > c.w ? 32 : 0);
        box.before_near = box.before_near || c.z < -c.w || c.w <= 0;
        const glm::vec3 n = glm::vec3{c} / c.w;
        box.low = glm::min(box.low, n);
        box.high = glm::max(box.high, n);
    }
    box.outside = outside != 0;
    return box;
}

} // namespace

void cull(std::span<const Cluster> clusters, const glm::mat4& clip_from_world,
          glm::ivec2 depth_size, std::span<const float> tiles, std::span<std::uint8_t> visible) {
    const glm::ivec2 tile_count = tiles_for(depth_size);
    const glm::vec2 size{depth_size};
    const auto tile = [&](glm::vec2 texel) {
        const glm::vec2 place = texel * (1.0F / LA_TILE);
        return glm::clamp(glm::ivec2{std::floor(place.x), std::floor(place.y)}, glm::ivec2{0},
                          tile_count - 1);
    };
    const auto is_hidden = [&](const ScreenBox& box) {
        const glm::ivec2 first = tile((glm::vec2{box.low} * 0.5F + 0.5F) * size - 1.0F);
        const glm::ivec2 last = tile((glm::vec2{box.high} * 0.5F + 0.5F) * size + 1.0F);
        const float nearest = box.low.z * 0.5F + 0.5F - 4 * LA_DEPTH_ROUNDING;
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                if (tiles[static_cast<std::size_t>(y) * tile_count.x + x] >= nearest) return false;
            }
        }
        return true;
    };
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const ScreenBox box = screen_box(clusters[i], clip_from_world);
        visible[i] = !box.outside && (box.before_near || !is_hidden(box)) ? 1 : 0;
    }
}

} // namespace lineatlas::compute::reference
