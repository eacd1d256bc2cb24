#include "truth_views.hpp"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace lineatlas::test {

Camera front_camera() {
    Camera camera;
    camera.size = {400, 400};
    camera.view = glm::lookAt(glm::vec3{0, 0, 10}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = glm::perspective(2 * std::atan(0.2F), 1.0F, 1.0F, 100.0F);
    return camera;
}

void add_panel(Mesh& mesh, glm::vec2 low, glm::vec2 high, float z) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(
        mesh.positions.end(),
        {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
}

void add_block(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back({(corner & 1) != 0 ? high.x : low.x,
                                  (corner & 2) != 0 ? high.y : low.y,
                                  (corner & 4) != 0 ? high.z : low.z});
    }
    constexpr std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
        mesh.triangles.push_back(glm::uvec3{q[0], q[1], q[2]} + first);
        mesh.triangles.push_back(glm::uvec3{q[0], q[2], q[3]} + first);
    }
}

void add_stroke(Mesh& mesh, glm::vec3 p, glm::vec3 q) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(p);
    mesh.positions.push_back(q);
    mesh.polylines.push_back({first, first + 1});
}

Mesh open_tube(double radius, std::uint32_t sectors) {
    Mesh mesh;
    for (std::uint32_t j = 0; j < sectors; ++j) {
        const double angle = 2 * std::numbers::pi * (j + 0.25) / sectors;
        for (const float y : {-1.0F, 1.0F})
            mesh.positions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
    }
    for (std::uint32_t j = 0; j < sectors; ++j) {
        const std::uint32_t a = 2 * j, b = 2 * ((j + 1) % sectors);
        mesh.triangles.emplace_back(a, a + 1, b + 1);
        mesh.triangles.emplace_back(a, b + 1, b);
    }
    return mesh;
}

} // namespace lineatlas::test
