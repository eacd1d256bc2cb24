#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"

// Views and meshes whose visible lines are known by hand.
namespace lineatlas::test {

/// 400 x 400 pixels, 100 per unit in the plane z = 0, looking along -z from a distance of 10.
Camera front_camera();

/// A rectangle that faces the front camera, from corner to corner at depth z.
void add_panel(Mesh& mesh, glm::vec2 low, glm::vec2 high, float z);

/// A box of twelve triangles.
void add_block(Mesh& mesh, glm::vec3 low, glm::vec3 high);

/// A polyline of one segment.
void add_stroke(Mesh& mesh, glm::vec3 p, glm::vec3 q);

/// An open tube along y about the origin, from y = -1 to 1.
Mesh open_tube(double radius, std::uint32_t sectors);

} // namespace lineatlas::test
