#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// A line in space; `direction` is a unit vector.
struct Axis {
    glm::vec3 point{0, 0, 0};
    glm::vec3 direction{0, 1, 0};
};

/// `view` carried around the axis by a share of a full turn, counter-clockwise seen from above. Its
/// planes are fitted anew.
View turned(const View& view, const Axis& axis, double turn);

/// Points that bound what the given ones sweep over in a full turn: what a camera must frame so
/// that a turning model never leaves the picture.
std::vector<glm::vec3> swept(std::span<const glm::vec3> points, const Axis& axis);

} // namespace lineatlas
