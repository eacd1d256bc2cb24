#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

namespace lineatlas {

/// A half line in the model's coordinates; `direction` is a unit vector.
struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1};

    glm::dvec3 at(double distance) const { return origin + distance * direction; }
};

/// The distance along the ray at which it meets a triangle, from either side; infinity if it does
/// not.
double meet(const Ray& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

/// A triangle that a ray meets, and how far along the ray.
struct RayHit {
    std::uint32_t triangle;
    double distance;
};

/// The first hit of the ray among the triangles for which `counts` returns true.
template <class Counts>
std::optional<RayHit> first_hit(const Ray& ray, std::span<const glm::vec3> vertices,
                                std::span<const glm::uvec3> triangles, const Counts& counts) {
    std::optional<RayHit> first;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const glm::uvec3 t = triangles[i];
        const RayHit hit{i, meet(ray, vertices[t.x], vertices[t.y], vertices[t.z])};
        if (std::isfinite(hit.distance) && (!first || hit.distance < first->distance) &&
            counts(hit))
            first = hit;
    }
    return first;
}

/// The first hit among all triangles.
std::optional<RayHit> first_hit(const Ray& ray, std::span<const glm::vec3> vertices,
                                std::span<const glm::uvec3> triangles);

} // namespace lineatlas
