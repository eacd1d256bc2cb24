#include "blocking.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// The difference that two doubles of one depth may have.
constexpr double rounding = 1e-10;

bool contains(const std::vector<std::uint32_t>& values, std::uint32_t value) {
    return std::ranges::find(values, value) != values.end();
}

} // namespace

Blocking::Blocking(const RayScene& scene, const PreciseCamera& projection, const BlockingRule& rule,
                   std::uint32_t segment)
    : scene_(scene), projection_(projection),
      contact_(std::max(rule.contact * scene.extent(), 2.0 * scene.lines().precision)),
      patch_pixels_(rule.patch_pixels) {
    const Segment& line = scene.lines().segments[segment];
    const auto add = [&](std::uint32_t triangle) {
        if (contains(own_, triangle)) return;
        own_.push_back(triangle);
        const std::uint32_t patch = scene.patches()[triangle];
        if (!contains(own_patches_, patch)) own_patches_.push_back(patch);
    };
    for (const std::uint32_t triangle : scene.triangles_at(line.p)) {
        const glm::uvec3 t = scene.lines().triangles[triangle];
        if (t.x == line.q || t.y == line.q || t.z == line.q) add(triangle);
    }
    // Faces beside a part of an edge, or beside an intersection, do not have both of its ends as
    // corners.
    for (const std::uint32_t face : {line.face_a, line.face_b})
        if (face != LA_NO_FACE) add(face & LA_FACE_INDEX);
}

bool Blocking::is_own_surface(std::uint32_t triangle) const {
    return contains(own_patches_, scene_.patches()[triangle]);
}

std::optional<double> Blocking::before(const Sight& sight, std::uint32_t triangle) const {
    if (contains(own_, triangle)) return std::nullopt;
    const glm::uvec3 t = scene_.lines().triangles[triangle];
    const std::array corners{glm::dvec3{scene_.lines().vertices[t.x]},
                             glm::dvec3{scene_.lines().vertices[t.y]},
                             glm::dvec3{scene_.lines().vertices[t.z]}};
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = glm::length(normal);
    if (size == 0) return std::nullopt; // no area
    if (std::abs(glm::dot(normal, sight.spine - corners[0])) < contact_ * size) return std::nullopt;

    // Rays find triangles in floats, so a sight may just miss a triangle that is seen edge on. Then
    // the hit lies in its plane, but is kept between its corners.
    const glm::dvec3 way = sight.end - sight.origin;
    const double squared = glm::dot(way, way);
    double nearest = 1, farthest = 0;
    for (const glm::dvec3& corner : corners) {
        const double share = glm::dot(corner - sight.origin, way) / squared;
        nearest = &corner == corners.data() ? share : std::min(nearest, share);
        farthest = &corner == corners.data() ? share : std::max(farthest, share);
    }
    const double slope = glm::dot(normal, way);
    const double in_plane = glm::dot(normal, corners[0] - sight.origin) / slope;
    const double share = slope == 0 ? nearest : std::clamp(in_plane, nearest, farthest);
    if (!(share < 1 - rounding)) return std::nullopt;
    const glm::dvec3 hit = sight.origin + way * share;
    if (glm::dot(projection_.near_plane, glm::dvec4{hit, 1}) < 0) return std::nullopt;

    const double distance = (1 - share) * std::sqrt(squared);
    if (distance < patch_pixels_ * sight.pixel && is_own_surface(triangle)) return std::nullopt;
    return distance;
}

} // namespace lineatlas
