#include "standard_camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "shared/constants.h"

namespace lineatlas {
namespace {

glm::dvec4 row(const glm::mat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

void set_row(glm::mat4& m, int i, glm::dvec4 values) {
    for (int column = 0; column < 4; ++column) m[column][i] = static_cast<float>(values[column]);
}

/// The window depth of a projection before the depth range is applied: dot(depth, point) / dot(w,
/// point). It goes from 0 to 1 between the planes.
struct DepthRows {
    glm::dvec4 depth, w;
    bool reversed; ///< the projection's own depth is 1 at the near plane

    explicit DepthRows(const Camera& camera) : w(row(camera.projection, 3)) {
        const glm::dvec4 z = row(camera.projection, 2);
        depth = camera.clip.zero_to_one ? z : 0.5 * (z + w);
        const double away = w.z > 0 ? 1 : -1; // or a left-handed eye space
        const glm::dvec4 near{0, 0, away, 1}, far{0, 0, 2 * away, 1};
        reversed = at(far) < at(near);
        if (reversed) depth = w - depth;
    }
    /// The depth of a point, which grows away from the eye.
    double at(glm::dvec4 point) const { return glm::dot(depth, point) / glm::dot(w, point); }
};

/// The part of the range from 0 to 1 that a box takes up, with a margin.
glm::dvec2 covered_depth(const DepthRows& rows, const Camera& camera, const Bounds& bounds) {
    constexpr double margin = 1e-3;
    const glm::dmat4 eye_from_world{camera.view};
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point =
            eye_from_world * glm::dvec4{(corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                                        (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                                        (corner & 4) != 0 ? bounds.max.z : bounds.min.z, 1};
        const bool in_front = glm::dot(rows.w, point) > 0;
        const double depth = in_front ? rows.at(point) : 0;
        low = std::min(low, depth);
        high = std::max(high, depth);
    }
    low = std::max(low, 0.0);
    high = std::min(high, 1.0);
    if (!(low < high)) return {0, 1};
    const double extra = margin * (high - low);
    return {std::max(low - extra, 0.0), std::min(high + extra, 1.0)};
}

/// The camera with the window depth (depth of `rows` - nearest) * scale.
Camera with_depth(const Camera& camera, const DepthRows& rows, double nearest, double scale) {
    Camera result = camera;
    result.clip.zero_to_one = false;
    set_row(result.projection, 2, 2 * scale * (rows.depth - nearest * rows.w) - rows.w);
    return result;
}

Camera lower_left(Camera camera) {
    if (camera.clip.upper_left) set_row(camera.projection, 1, -row(camera.projection, 1));
    camera.clip.upper_left = false;
    return camera;
}

/// The largest error of a value: from its own steps, and from rounding before it was stored.
double depth_error(const DepthValues& values, double largest) {
    const double rounding = std::ldexp(largest, -23);
    return values.floating ? 1.5 * rounding
                           : 0.5 * rounding + 1 / (std::ldexp(1.0, values.bits) - 1);
}

} // namespace

StandardCamera standard_camera(const Camera& camera, const Bounds& bounds) {
    const Camera upright = lower_left(camera);
    const DepthRows rows{upright};
    if (!rows.reversed && !upright.clip.zero_to_one) return {upright, {}};
    const glm::dvec2 covered = covered_depth(rows, upright, bounds);
    return {with_depth(upright, rows, covered.x, 1 / (covered.y - covered.x)), {}};
}

StandardCamera standard_camera(const Camera& camera, const Bounds& bounds,
                               const DepthValues& values) {
    const Camera upright = lower_left(camera);
    const DepthRows rows{upright};
    const glm::dvec2 covered = covered_depth(rows, upright, bounds);
    // The depth values at the nearer plane and at the farther one.
    const double near = rows.reversed ? values.range.y : values.range.x;
    const double far = rows.reversed ? values.range.x : values.range.y;
    const auto value_at = [&](double depth) { return near + (far - near) * depth; };
    const double largest = std::max(std::abs(value_at(covered.x)), std::abs(value_at(covered.y)));
    const double error = depth_error(values, largest) / std::abs(far - near);
    const double scale = std::min(1 / (covered.y - covered.x), double{LA_DEPTH_ROUNDING} / error);
    // The matrix must agree with the numbers after their rounding to floats.
    const DepthMapping mapping{.reference = static_cast<float>(value_at(covered.x)),
                               .scale = static_cast<float>(scale / (far - near))};
    return {with_depth(upright, rows, (mapping.reference - near) / (far - near),
                       mapping.scale * (far - near)),
            mapping};
}

bool sees_from_outside(const Camera& camera, const Bounds& bounds) {
    const glm::mat4 clip_from_world = camera.clip_from_world();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 high{(corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0};
        const glm::vec4 clip =
            clip_from_world * glm::vec4{glm::mix(bounds.min, bounds.max, high), 1};
        if (!(clip.z > -clip.w)) return false;
    }
    return true;
}

} // namespace lineatlas
