#include "lineatlas/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/numbers.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_field_of_view(float fov_y) {
    if (fov_y > 0 && fov_y < glm::pi<float>()) return;
    throw UsageError("camera: the field of view must lie between 0 and 180 degrees");
}

/// The near and far distances that just hold the bounds. In a perspective view both lie in front of
/// the eye. For an eye within a model the near distance is a small, fixed share of the far one: a
/// smaller share costs depth precision, a larger one cuts off more.
glm::vec2 fit_planes(const View& view, const Bounds& bounds) {
    const glm::vec3 forward = glm::normalize(view.target - view.eye);
    float nearest = std::numeric_limits<float>::infinity();
    float farthest = -nearest;
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
    if (view.projection == Projection::orthographic) {
        const float room = margin * std::max({extent, std::abs(nearest), std::abs(farthest)});
        return {nearest - room, farthest + room};
    }
    const float far = std::max(farthest * (1 + margin), extent * smallest_share);
    return {std::max(nearest * (1 - margin), far * smallest_share), far};
}

struct NamedDirection {
    std::string_view name;
    float azimuth, elevation; ///< degrees
};
// In the dimetric view the front's axis keeps sqrt(1 - 7/9) of its length, the others sqrt(1 -
// 1/9).
constexpr std::array named_directions{
    NamedDirection{"front", 0, 0},
    NamedDirection{"back", 180, 0},
    NamedDirection{"left", -90, 0},
    NamedDirection{"right", 90, 0},
    NamedDirection{"top", 0, 90},
    NamedDirection{"bottom", 0, -90},
    NamedDirection{"isometric", 45, 35.264390F},
    NamedDirection{"dimetric", 20.704811F, 19.471221F},
};

/// "30,-12.5": two numbers, the second from -90 to 90.
std::optional<glm::vec2> parse_angles(std::string_view text) {
    const std::optional<float> azimuth = take_number<float>(text);
    if (!azimuth || !text.starts_with(',')) return {};
    text.remove_prefix(1);
    const std::optional<float> elevation = take_number<float>(text);
    if (!elevation || !text.empty() || !std::isfinite(*azimuth) || !(std::abs(*elevation) <= 90))
        return {};
    return glm::vec2{*azimuth, *elevation};
}

glm::vec2 angles_of(std::string_view name) {
    const auto known = std::ranges::find(named_directions, name, &NamedDirection::name);
    if (known != named_directions.end()) return {known->azimuth, known->elevation};
    const std::optional<glm::vec2> angles = parse_angles(name);
    if (angles) return *angles;
    std::string names;
    for (const NamedDirection& direction : named_directions) {
        names.append(direction.name).append(", ");
    }
    throw UsageError("there is no view \"" + std::string{name} + "\"; must be one of " + names +
                     "or AZIMUTH,ELEVATION in degrees, as in 30,20");
}

glm::vec3 front_of(glm::vec3 up) {
    return std::abs(up.z) > 0.5F ? glm::vec3{0, -1, 0} : glm::vec3{0, 0, 1};
}

/// An orthographic view whose picture the points just fill.
View frame_flat(const ViewDirection& direction, std::span<const glm::vec3> points, glm::vec3 center,
                glm::ivec2 size, float fov_y, float margin) {
    const glm::vec3 side = glm::normalize(glm::cross(direction.up, direction.toward_eye));
    const glm::vec3 above = glm::cross(direction.toward_eye, side);
    glm::vec3 low{std::numeric_limits<float>::infinity()}, high = -low;
    for (const glm::vec3& point : points) {
        const glm::vec3 offset = point - center;
        const glm::vec3 at{glm::dot(offset, side), glm::dot(offset, above),
                           glm::dot(offset, direction.toward_eye)};
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const glm::vec3 extent = high - low;
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    float height = std::max(extent.y, extent.x / aspect) / margin;
    if (!(height > 0)) height = extent.z > 0 ? extent.z : 1;
    const glm::vec3 target = center + 0.5F * ((low.x + high.x) * side + (low.y + high.y) * above);
    const float distance = 0.5F * height / std::tan(0.5F * fov_y);
    return {.eye = target + distance * direction.toward_eye,
            .target = target,
            .up = direction.up,
            .fov_y = fov_y,
            .projection = Projection::orthographic};
}

} // namespace

std::string_view name_of(Projection projection) {
    return projection == Projection::perspective ? "perspective" : "orthographic";
}

Projection parse_projection(std::string_view name) {
    for (const Projection known : {Projection::perspective, Projection::orthographic}) {
        if (name_of(known) == name) return known;
    }
    throw UsageError("unknown projection \"" + std::string{name} +
                     "\"; must be perspective or orthographic");
}

float shown_height(const View& view) {
    return 2 * glm::length(view.target - view.eye) * std::tan(0.5F * view.fov_y);
}

View with_shown_height(const View& view, float height) {
    if (!(height > 0) || !std::isfinite(height))
        throw UsageError("camera: the height that is shown must be a number above 0");
    View moved = view;
    moved.eye = view.target + (view.eye - view.target) * (height / shown_height(view));
    return moved;
}

ViewDirection view_direction(std::string_view name, glm::vec3 up) {
    const glm::vec2 angles = glm::radians(angles_of(name));
    const glm::vec3 front = front_of(up);
    const glm::vec3 right = glm::cross(up, front);
    const glm::vec3 level = std::sin(angles[0]) * right + std::cos(angles[0]) * front;
    if (std::abs(angles[1]) > glm::radians(89.99F)) {
        const float above = angles[1] > 0 ? 1.0F : -1.0F;
        return {.toward_eye = above * up, .up = -above * level};
    }
    return {.toward_eye = std::cos(angles[1]) * level + std::sin(angles[1]) * up, .up = up};
}

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
    check_field_of_view(view.fov_y);
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
        if (bounds.min.x > bounds.max.x)
            throw UsageError("camera: the model has no points to frame");
        const glm::vec2 fitted = fit_planes(view, bounds);
        if (view.near <= 0) planes.x = fitted.x;
        if (view.far <= 0) {
            planes.y = std::max(fitted.y, planes.x + 1e-3F * std::max(std::abs(planes.x), 1e-30F));
        }
    }
    if (planes.y <= planes.x) {
        throw UsageError("camera: the far plane must lie behind the near plane");
    }
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const auto projection = [&] {
        if (view.projection == Projection::perspective)
            return glm::perspective(view.fov_y, aspect, planes.x, planes.y);
        const float half = 0.5F * shown_height(view);
        return glm::ortho(-aspect * half, aspect * half, -half, half, planes.x, planes.y);
    };
    return {
        .view = glm::lookAt(view.eye, view.target, up), .projection = projection(), .size = size};
}

View frame_points(std::span<const glm::vec3> points, glm::ivec2 size, glm::vec3 up, float fov_y,
                  Projection projection) {
    // From the front, to the right and above: the usual view of a technical illustration.
    const glm::vec3 front = front_of(up);
    const glm::vec3 right = glm::cross(up, front);
    return frame_points_from({glm::normalize(0.75F * right + front + 0.6F * up), up}, points, size,
                             fov_y, projection);
}

View frame_points_from(const ViewDirection& direction, std::span<const glm::vec3> points,
                       glm::ivec2 size, float fov_y, Projection projection) {
    const glm::vec3 toward_eye = direction.toward_eye;
    check_field_of_view(fov_y);
    if (points.empty()) throw UsageError("camera: the model has no points to frame");
    Bounds bounds;
    for (const glm::vec3& point : points) {
        bounds.min = glm::min(bounds.min, point);
        bounds.max = glm::max(bounds.max, point);
    }
    const glm::vec3 center = 0.5F * (bounds.min + bounds.max);
    constexpr float margin = 0.92F;
    if (projection == Projection::orthographic) {
        return frame_flat(direction, points, center, size, fov_y, margin);
    }
    const glm::vec3 side = glm::normalize(glm::cross(direction.up, toward_eye));
    const glm::vec3 above = glm::cross(toward_eye, side);

    // The nearest eye from which all points lie inside the frame, less a margin. Each border of the
    // frame is a plane through the eye; in the coordinates (along the axis, forward) of an axis the
    // two borders ask that low + tan * e_forward <= e_axis <= high - tan * e_forward.
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
    // The eye keeps clear of the nearest point, even if the frame's borders would let it touch the
    // point.
    constexpr float clearance = 5e-3F;
    const float extent = glm::length(bounds.max - bounds.min);
    float nearest = 0;
    for (const glm::vec3& point : points) {
        nearest = std::min(nearest, -glm::dot(point - center, toward_eye));
    }
    forward = std::min(forward, nearest - (extent > 0 ? clearance * extent : 1.0F));
    // The axis with room to spare centres the model's outline on the screen.
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
    return {.eye = eye, .target = center + on_axis, .up = direction.up, .fov_y = fov_y};
}

} // namespace lineatlas
