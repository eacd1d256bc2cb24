#include "lineatlas/camera_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

glm::dmat3 rotation(const Axis& axis, double turn) {
    if (!(std::abs(glm::length(axis.direction) - 1) < 1e-3F))
        throw UsageError("the direction of an axis must be a unit vector");
    const double angle = 2 * std::numbers::pi * turn;
    return glm::dmat3{glm::rotate(glm::dmat4{1}, angle, glm::dvec3{axis.direction})};
}

} // namespace

View turned(const View& view, const Axis& axis, double turn) {
    const glm::dmat3 turning = rotation(axis, turn);
    const glm::dvec3 fixed{axis.point};
    View result = view;
    result.eye = glm::vec3{fixed + turning * (glm::dvec3{view.eye} - fixed)};
    result.target = glm::vec3{fixed + turning * (glm::dvec3{view.target} - fixed)};
    result.up = glm::vec3{turning * glm::dvec3{view.up}};
    result.near = result.far = 0;
    return result;
}

std::vector<glm::vec3> swept(std::span<const glm::vec3> points, const Axis& axis) {
    if (points.empty()) return {};
    const auto height = [&](glm::vec3 p) { return glm::dot(p - axis.point, axis.direction); };
    const auto [lowest, highest] =
        std::ranges::minmax(points, {}, height); // slices lie between these two
    const float low = height(lowest);
    const float range = height(highest) - low;
    constexpr std::size_t slices = 64;
    struct Slice {
        float low = 0, high = 0, radius = -1;
    };
    std::array<Slice, slices> all{};
    for (const glm::vec3& point : points) {
        const float h = height(point);
        if (!std::isfinite(h)) throw UsageError("points that are swept must be finite");
        const float place = range > 0 ? (h - low) / range * (slices - 1) : 0;
        Slice& slice = all[static_cast<std::size_t>(place)];
        const float radius = glm::distance(point, axis.point + h * axis.direction);
        slice.low = slice.radius < 0 ? h : std::min(slice.low, h);
        slice.high = slice.radius < 0 ? h : std::max(slice.high, h);
        slice.radius = std::max(slice.radius, radius);
    }

    constexpr int corners = 32;
    // The corners of a polygon around a circle lie outside it.
    const float outside = 1 / std::cos(std::numbers::pi_v<float> / corners);
    const glm::vec3 other =
        std::abs(axis.direction.x) < 0.9F ? glm::vec3{1, 0, 0} : glm::vec3{0, 1, 0};
    const glm::vec3 side = glm::normalize(glm::cross(axis.direction, other));
    std::vector<glm::vec3> result;
    for (int corner = 0; corner < corners; ++corner) {
        const glm::dmat3 turning = rotation(axis, static_cast<double>(corner) / corners);
        const glm::vec3 outwards = glm::vec3{turning * glm::dvec3{side}} * outside;
        for (const Slice& slice : all) {
            if (slice.radius < 0) continue;
            for (const float h : {slice.low, slice.high}) {
                result.push_back(axis.point + h * axis.direction + slice.radius * outwards);
            }
        }
    }
    return result;
}

} // namespace lineatlas
