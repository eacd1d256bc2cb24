#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"

// Lines before and behind bodies. The visible parts of the lines are known by hand.
namespace lineatlas::test {

constexpr int side = 400;        // of the viewport, pixels
constexpr double per_unit = 100; // pixels, at z = 0
constexpr double eye_z = 10;

/// A camera at (0, 0, 10) that looks along -z. At z = 0 both projections show the same frame.
Camera front_camera(bool perspective);

/// Window position in pixels.
glm::dvec2 window(const Camera& camera, glm::vec3 point);
double length_px(const Camera& camera, glm::vec3 p, glm::vec3 q);

/// A span of a line on the screen, pixels from its start.
struct Span {
    double from, to;
};

/// A line and its visible parts.
struct Answer {
    glm::vec3 p, q;
    std::vector<Span> visible;
};

struct Known {
    Mesh mesh;
    std::vector<Answer> answers;

    std::uint32_t vertex(glm::vec3 position) {
        mesh.positions.push_back(position);
        return static_cast<std::uint32_t>(mesh.positions.size() - 1);
    }
    void quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        const std::uint32_t first = vertex(a);
        vertex(b), vertex(c), vertex(d);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
    /// Adds a sheet that faces the eye.
    void sheet(glm::vec2 low, glm::vec2 high, float z) {
        quad({low, z}, {high.x, low.y, z}, {high, z}, {low.x, high.y, z});
    }
    void box(glm::vec3 low, glm::vec3 high) {
        const auto corner = [&](int i) {
            return glm::vec3{(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                             (i & 4) != 0 ? high.z : low.z};
        };
        constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (const auto& q : quads) quad(corner(q[0]), corner(q[1]), corner(q[2]), corner(q[3]));
    }
    void line(glm::vec3 p, glm::vec3 q, std::vector<Span> visible) {
        const std::uint32_t first = vertex(p);
        vertex(q);
        mesh.polylines.push_back({first, first + 1});
        answers.push_back({p, q, std::move(visible)});
    }
};

struct Case {
    const char* name;
    Known (*make)(bool perspective, const Camera& camera);
    Camera (*camera)(bool perspective) = front_camera;
};

std::span<const Case> known_cases();

} // namespace lineatlas::test
