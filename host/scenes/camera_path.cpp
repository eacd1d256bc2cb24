#include "camera_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lineatlas::scenes {

namespace {

/// Catmull-Rom: passes through b and c, with tangents from the neighbours.
glm::vec3 spline(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, float s) {
    return 0.5F *
           (2.0F * b +
            s * (c - a + s * (2.0F * a - 5.0F * b + 4.0F * c - d + s * (3.0F * (b - c) + d - a))));
}

} // namespace

std::function<View(float)> orbit(glm::vec3 target, float distance, float elevation, float start,
                                 float near, float far) {
    return [=](float t) {
        // The end of the orbit equals its start, to the last bit.
        const float turns = t - std::floor(t);
        const float angle = start + 2 * std::numbers::pi_v<float> * turns;
        const glm::vec3 direction{std::cos(elevation) * std::cos(angle), std::sin(elevation),
                                  std::cos(elevation) * std::sin(angle)};
        View view;
        view.target = target;
        view.eye = target + distance * direction;
        view.near = near;
        view.far = far;
        return view;
    };
}

std::function<View(float)> walk(std::vector<Station> stations, float fov_y, float near, float far) {
    return [stations = std::move(stations), fov_y, near, far](float t) {
        const int last = static_cast<int>(stations.size()) - 1;
        const float along = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(last);
        const int from = std::min(static_cast<int>(along), last - 1);
        auto station = [&](int i) -> const Station& {
            return stations[static_cast<std::size_t>(std::clamp(i, 0, last))];
        };
        const float s = along - static_cast<float>(from);
        const Station& a = station(from - 1);
        const Station& b = station(from);
        const Station& c = station(from + 1);
        const Station& d = station(from + 2);
        View view;
        view.eye = spline(a.eye, b.eye, c.eye, d.eye, s);
        view.target = spline(a.target, b.target, c.target, d.target, s);
        view.fov_y = fov_y;
        view.near = near;
        view.far = far;
        return view;
    };
}

} // namespace lineatlas::scenes
