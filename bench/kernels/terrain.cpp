#include "terrain.hpp"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace lineatlas::bench {

Terrain make_terrain(std::uint32_t triangles, std::uint32_t segments) {
    // k * k cells have two triangles and at least two edges each.
    const auto cells = static_cast<double>(std::max(triangles, segments) / 2 + 1);
    const auto k = static_cast<std::uint32_t>(std::ceil(std::sqrt(cells)));
    Terrain terrain;
    Random random{4};
    for (std::uint32_t y = 0; y <= k; ++y) {
        for (std::uint32_t x = 0; x <= k; ++x) {
            const auto place = [&](std::uint32_t i) {
                return static_cast<float>(i) / static_cast<float>(k) - 0.5F;
            };
            terrain.vertices.insert(
                terrain.vertices.end(),
                {place(x), random.between(0, 2 / static_cast<float>(k)), place(y)});
        }
    }
    terrain.vertex_count = (k + 1) * (k + 1);
    terrain.segments.reserve(segments);
    for (std::uint32_t y = 0; y < k; ++y) {
        for (std::uint32_t x = 0; x < k; ++x) {
            const std::uint32_t corner = y * (k + 1) + x;
            const std::uint32_t face = 2 * (y * k + x);
            terrain.triangles.insert(
                terrain.triangles.end(),
                {corner, corner + k + 1, corner + 1, corner + 1, corner + k + 1, corner + k + 2});
            // The diagonal, and the edge shared with the previous cell.
            const Segment diagonal{corner + 1, corner + k + 1, face, face + 1, 0, 0,
                                   0,          LA_KIND_CREASE};
            const Segment side{corner, corner + k + 1, face, x > 0 ? face - 1 : LA_NO_FACE, 0, 0,
                               0,      LA_KIND_CREASE};
            if (terrain.segments.size() < segments) terrain.segments.push_back(diagonal);
            if (terrain.segments.size() < segments) terrain.segments.push_back(side);
        }
    }
    const glm::vec3 eye{0.3F, 1.2F, 0.9F};
    terrain.eye = {eye, 1};
    terrain.clip_from_world = glm::perspective(0.9F, 4.0F / 3.0F, 0.1F, 10.0F) *
                              glm::lookAt(eye, glm::vec3{0}, glm::vec3{0, 1, 0});
    return terrain;
}

} // namespace lineatlas::bench
