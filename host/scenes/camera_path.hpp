#pragma once

#include <functional>
#include <vector>

#include "lineatlas/camera.hpp"

namespace lineatlas::scenes {

/// A station of a walkthrough.
struct Station {
    glm::vec3 eye;
    glm::vec3 target;
};

/// A full turn about the vertical through `target`, starting at `start` radians from the x axis
/// towards z. view(1) is exactly view(0).
std::function<View(float)> orbit(glm::vec3 target, float distance, float elevation, float start,
                                 float near, float far);

/// A smooth walk through the stations, which are evenly spaced in t.
std::function<View(float)> walk(std::vector<Station> stations, float fov_y, float near, float far);

} // namespace lineatlas::scenes
