#include "projection.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace lineatlas {
namespace {

/// Camera::eye() in double precision.
glm::dvec4 eye_of(const glm::dmat4& world_from_clip, bool parallel) {
    const glm::dvec4 point = world_from_clip * glm::dvec4{0, 0, 1, 0};
    if (!parallel) return point / point.w;
    return {-glm::normalize(glm::dvec3{point}), 0};
}

glm::dvec4 row(const glm::dmat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

} // namespace

PreciseCamera::PreciseCamera(const Camera& camera, const Bounds& bounds)
    : clip_from_world(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
      world_from_clip(glm::inverse(clip_from_world)), viewport(camera.size),
      eye(eye_of(world_from_clip, camera.projection[2][3] == 0)),
      near_plane(row(clip_from_world, 2) + row(clip_from_world, 3)),
      pixel_rate(2 / (camera.projection[1][1] * viewport.y)) {
    if (eye.w != 0) return;
    const glm::dvec3 toward{eye};
    const glm::dvec3 corner{toward.x > 0 ? bounds.max.x : bounds.min.x,
                            toward.y > 0 ? bounds.max.y : bounds.min.y,
                            toward.z > 0 ? bounds.max.z : bounds.min.z};
    const double extent = glm::length(glm::dvec3{bounds.max - bounds.min});
    farthest_toward_eye = glm::dot(corner, toward) + extent;
}

glm::dvec3 PreciseCamera::start_of_sight(const glm::dvec3& point) const {
    const glm::dvec3 toward{eye};
    if (eye.w != 0) return toward;
    return point + toward * (farthest_toward_eye - glm::dot(point, toward));
}

glm::dvec2 PreciseCamera::picture(const glm::dvec4& clip) const {
    const glm::dvec2 device = glm::dvec2{clip} / clip.w;
    return glm::dvec2{device.x + 1, 1 - device.y} * viewport * 0.5;
}

SeenLine::SeenLine(const PreciseCamera& projection, const glm::dvec3& p, const glm::dvec3& q,
                   double t0, double t1)
    : projection_(projection) {
    const glm::dvec4 whole_p = projection.clip_from_world * glm::dvec4{p, 1};
    const glm::dvec4 whole_q = projection.clip_from_world * glm::dvec4{q, 1};
    p_ = whole_p + (whole_q - whole_p) * t0;
    q_ = whole_p + (whole_q - whole_p) * t1;
    start_ = projection.picture(p_);
    end_ = projection.picture(q_);
    length_ = glm::distance(start_, end_);
    // A line seen end on has no direction. Any direction will do.
    direction_ = length_ > 0 ? (end_ - start_) / length_ : glm::dvec2{1, 0};
}

bool SeenLine::is_left(const glm::dvec3& way) const {
    const glm::dvec4 clip = 0.5 * (p_ + q_);
    const glm::dvec4 turn = projection_.clip_from_world * glm::dvec4{way, 0};
    // The change of clip.xy / clip.w, times a positive factor.
    const glm::dvec2 change =
        (glm::dvec2{turn} * clip.w - glm::dvec2{clip} * turn.w) * projection_.viewport;
    return glm::dot(change, glm::dvec2{direction_.y, direction_.x}) > 0;
}

Sight SeenLine::sight(double u, double across) const {
    // Linear in the picture means hyperbolic in clip space.
    const double v = u * p_.w / (u * p_.w + (1 - u) * q_.w);
    const glm::dvec4 spine = p_ + (q_ - p_) * v;
    const auto point = [&](const glm::dvec4& clip) {
        const glm::dvec4 world = projection_.world_from_clip * clip;
        return glm::dvec3{world} / world.w;
    };
    // To the left is (y, -x) where y points down, and (y, x) where it points up.
    const glm::dvec2 left = glm::dvec2{direction_.y, direction_.x} * 2.0 / projection_.viewport;
    const glm::dvec4 aside = spine + glm::dvec4{left * (across * spine.w), 0, 0};
    Sight sight{};
    sight.spine = point(spine);
    sight.end = across == 0 ? sight.spine : point(aside);
    sight.origin = projection_.start_of_sight(sight.end);
    sight.pixel = projection_.pixel_rate * spine.w;
    return sight;
}

std::optional<LinePart> part_inside(const PreciseCamera& projection, const glm::dvec3& p,
                                    const glm::dvec3& q) {
    const glm::dvec4 clip_p = projection.clip_from_world * glm::dvec4{p, 1};
    const glm::dvec4 clip_q = projection.clip_from_world * glm::dvec4{q, 1};
    LinePart part{0, 1};
    for (int axis = 0; axis < 3; ++axis) { // Liang and Barsky 1984
        for (const double side : {-1.0, 1.0}) {
            const double at_p = clip_p.w + side * clip_p[axis];
            const double at_q = clip_q.w + side * clip_q[axis];
            if (at_p < 0 && at_q < 0) return std::nullopt;
            if (at_p < 0) part.t0 = std::max(part.t0, at_p / (at_p - at_q));
            if (at_q < 0) part.t1 = std::min(part.t1, at_p / (at_p - at_q));
        }
    }
    if (!(part.t0 < part.t1)) return std::nullopt;
    return part;
}

} // namespace lineatlas
