#include "lineatlas/camera.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Near and far distances that just hold the bounds in front of the eye. Inside a model the near
/// plane is a fixed small share of the far distance: depth precision against what may be cut off.
glm::vec2 fit_planes(const View& view, const Bounds& bounds) {
    const glm::vec3 forward = glm::normalize(view.target - view.eye);
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point{(corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                              (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                              (corner & 4) != 0 ? bounds.max.z : bounds.min.z};
        const float distance = glm::dot(point - view.eye, forward);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    constexpr float margin = 1e-3F;
    constexpr float smallest_share = 1e-3F;
    const float extent = glm::length(bounds.max - bounds.min);
    const float far = std::max(farthest * (1 + margin), extent * smallest_share);
    return {std::max(nearest * (1 - margin), far * smallest_share), far};
}

} // namespace

glm::vec4 Camera::eye() const {
    // The eye is what every projection maps to x = y = w = 0: (0, 0, 1, 0) in clip space. For a
    // parallel projection that is the direction of sight.
    const glm::vec4 point = glm::inverse(clip_from_world()) * glm::vec4{0, 0, 1, 0};
    if (std::abs(projection[2][3]) > 0) return point / point.w;
    return {-glm::normalize(glm::vec3{point}), 0};
}

Camera make_camera(const View& view, glm::ivec2 size, const Bounds& bounds) {
    if (size.x <= 0 || size.y <= 0) throw UsageError("camera: the picture size must be positive");
    if (!finite(view.eye) || !finite(view.target) || !finite(view.up) ||
        !std::isfinite(view.fov_y) || !std::isfinite(view.near) || !std::isfinite(view.far)) {
        throw UsageError("camera: eye, target, up and field of view must be finite numbers");
    }
    if (view.fov_y <= 0 || view.fov_y >= glm::pi<float>()) {
        throw UsageError("camera: the field of view must lie between 0 and 180 degrees");
    }
    const glm::vec3 sight = view.target - view.eye;
    const float distance = glm::length(sight);
    if (!(distance > 0) || !std::isfinite(distance)) {
        throw UsageError("camera: eye and target must be two different points");
    }
    const glm::vec3 up_size = glm::abs(view.up);
    const glm::vec3 up = view.up / std::max({up_size.x, up_size.y, up_size.z}); // no overflow
    if (!(glm::length(glm::cross(sight / distance, up)) > 1e-6F)) {
        throw UsageError("camera: up must not point along the line of sight");
    }
    glm::vec2 planes{view.near, view.far};
    if (view.near <= 0 || view.far <= 0) {
        if (bounds.min.x > bounds.max.x) throw UsageError("camera: there is nothing to look at");
        const glm::vec2 fitted = fit_planes(view, bounds);
        if (view.near <= 0) planes.x = fitted.x;
        if (view.far <= 0) planes.y = std::max(fitted.y, planes.x * 1.001F);
    }
    if (planes.y <= planes.x) {
        throw UsageError("camera: the far plane must lie behind the near plane");
    }
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    return {.view = glm::lookAt(view.eye, view.target, up),
            .projection = glm::perspective(view.fov_y, aspect, planes.x, planes.y),
            .size = size};
}

View frame_points(std::span<const glm::vec3> points, glm::ivec2 size, glm::vec3 up, float fov_y) {
    // From the front, to the right and above: the usual view of a technical illustration.
    const glm::vec3 front = std::abs(up.z) > 0.5F ? glm::vec3{0, -1, 0} : glm::vec3{0, 0, 1};
    const glm::vec3 right = glm::cross(up, front);
    return frame_points_from(glm::normalize(0.75F * right + front + 0.6F * up), points, size, up,
                             fov_y);
}

View frame_points_from(glm::vec3 toward_eye, std::span<const glm::vec3> points, glm::ivec2 size,
                       glm::vec3 up, float fov_y) {
    if (points.empty()) throw UsageError("camera: there is nothing to look at");
    Bounds bounds;
    for (const glm::vec3& point : points) {
        bounds.min = glm::min(bounds.min, point);
        bounds.max = glm::max(bounds.max, point);
    }
    const glm::vec3 center = 0.5F * (bounds.min + bounds.max);
    const glm::vec3 side = glm::normalize(glm::cross(up, toward_eye));
    const glm::vec3 above = glm::cross(toward_eye, side);

    // The nearest eye from which all points lie inside the frame, less a margin. Each border of the
    // frame is a plane through the eye; in the coordinates (along the axis, forward) of an axis the
    // two borders ask that low + tan * e_forward <= e_axis <= high - tan * e_forward.
    constexpr float margin = 0.92F;
    const float tan_y = std::tan(0.5F * fov_y) * margin;
    const float tan_x = tan_y * static_cast<float>(size.x) / static_cast<float>(size.y);
    struct Borders {
        float low = -std::numeric_limits<float>::infinity();
        float high = std::numeric_limits<float>::infinity();
        void include(float axis, float forward, float tan) {
            low = std::max(low, axis - tan * forward);
            high = std::min(high, axis + tan * forward);
        }
    } horizontal, vertical;
    for (const glm::vec3& point : points) {
        const glm::vec3 offset = point - center; // keeps precision far from the origin
        const float forward = -glm::dot(offset, toward_eye);
        horizontal.include(glm::dot(offset, side), forward, tan_x);
        vertical.include(glm::dot(offset, above), forward, tan_y);
    }
    float forward = std::min((horizontal.high - horizontal.low) / (2 * tan_x),
                             (vertical.high - vertical.low) / (2 * tan_y));
    // Clear of the nearest point also where the frame's borders would let the eye touch it.
    constexpr float clearance = 5e-3F;
    const float extent = glm::length(bounds.max - bounds.min);
    float nearest = 0;
    for (const glm::vec3& point : points) {
        nearest = std::min(nearest, -glm::dot(point - center, toward_eye));
    }
    forward = std::min(forward, nearest - (extent > 0 ? clearance * extent : 1.0F));
    // Along the axis with room to spare, the model's outline is centred on the screen.
    const auto centred = [&](const Borders& borders, float tan, glm::vec3 axis) {
        float low = borders.low + tan * forward;
        float high = borders.high - tan * forward;
        for (int step = 0; step < 16; ++step) {
            const float middle = 0.5F * (low + high);
            glm::vec2 range{std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()};
            for (const glm::vec3& point : points) {
                const glm::vec3 offset = point - center;
                const float depth = -glm::dot(offset, toward_eye) - forward;
                const float position = (glm::dot(offset, axis) - middle) / depth;
                range = {std::min(range.x, position), std::max(range.y, position)};
            }
            (range.x + range.y > 0 ? low : high) = middle;
        }
        return 0.5F * (low + high);
    };
    const glm::vec3 on_axis =
        centred(horizontal, tan_x, side) * side + centred(vertical, tan_y, above) * above;
    const glm::vec3 eye = center + on_axis - forward * toward_eye;
    return {.eye = eye, .target = center + on_axis, .up = up, .fov_y = fov_y};
}

} // namespace lineatlas
