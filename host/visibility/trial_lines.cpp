#include "trial_lines.hpp"

#include <cstdint>

#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas {
namespace {

void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i < 8; ++i)
        mesh.positions.emplace_back((i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                                    (i & 4U) != 0 ? high.z : low.z);
    for (const glm::uvec3 triangle : {glm::uvec3{0, 2, 3},
                                      {0, 3, 1},
                                      {4, 5, 7},
                                      {4, 7, 6},
                                      {0, 1, 5},
                                      {0, 5, 4},
                                      {2, 6, 7},
                                      {2, 7, 3},
                                      {0, 4, 6},
                                      {0, 6, 2},
                                      {1, 3, 7},
                                      {1, 7, 5}})
        mesh.triangles.push_back(triangle + first);
}

} // namespace

LineSet trial_lines() {
    Mesh mesh;
    add_box(mesh, {0, 0, 0}, {4, 1, 3});
    for (int i = 0; i < 8; ++i) { // enough runs for kernels to draw strokes, too
        const glm::vec3 place{0.3F + static_cast<float>(i % 4), 0.5F,
                              0.3F + 1.4F * static_cast<float>(i / 4)};
        add_box(mesh, place, place + glm::vec3{0.9F, 1 + 0.3F * static_cast<float>(i % 3), 0.6F});
    }
    return extract_lines(mesh);
}

Camera trial_camera(const LineSet& lines) {
    const glm::ivec2 size{96, 64};
    return make_camera(frame_points(lines.vertices, size), size, lines.bounds);
}

} // namespace lineatlas
