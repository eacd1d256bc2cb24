#include "describe_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/matrix.hpp>

namespace lineatlas {
namespace {

/// `digits`: a float has 7; a place far from zero needs more.
std::string written(glm::dvec3 v, int digits = 7) {
    return fmt::format("{:.{}g},{:.{}g},{:.{}g}", v.x, digits, v.y, digits, v.z, digits);
}

} // namespace

std::string describe_camera(const Camera& camera, glm::dvec3 origin) {
    const glm::mat4& v = camera.view;
    const glm::dvec3 forward{-v[0][2], -v[1][2], -v[2][2]};
    const glm::vec3 up{v[0][1], v[1][1], v[2][1]};
    const int digits = origin == glm::dvec3{0} ? 7 : 15;
    const auto options = [&](glm::dvec3 eye, double distance, float fov) {
        return fmt::format("--eye {} --target {} --up {} --fov {:.6g}",
                           written(eye + origin, digits),
                           written(eye + distance * forward + origin, digits), written(up), fov);
    };
    const float half_height = 1 / camera.projection[1][1];
    if (camera.eye().w == 0) { // a parallel view becomes one from where an angle of 40 degrees
                               // shows as much
        const glm::dvec3 place{glm::inverse(v)[3]};
        const double distance = half_height / std::tan(0.5F * View{}.fov_y);
        return options(place, distance, 40) + " --projection orthographic";
    }
    const glm::dvec3 eye{camera.eye()};
    // The target is so far away that the digits of both places tell where the camera looks.
    const double distance = std::max({1.0, std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)});
    return options(eye, distance, 2 * std::atan(half_height) * 180 / std::numbers::pi_v<float>);
}

} // namespace lineatlas
