#include "ray.hpp"

#include <limits>

#include <glm/geometric.hpp>

namespace lineatlas {

double meet(const Ray& ray, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    constexpr double missed = std::numeric_limits<double>::infinity();
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) return missed;
    const glm::dvec3 offset = ray.origin - a;
    const double u = glm::dot(offset, p) / determinant;
    if (!(u >= 0 && u <= 1)) return missed;
    const glm::dvec3 q = glm::cross(offset, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (!(v >= 0 && u + v <= 1)) return missed;
    const double distance = glm::dot(ac, q) / determinant;
    return distance > 0 ? distance : missed;
}

std::optional<RayHit> first_hit(const Ray& ray, std::span<const glm::vec3> vertices,
                                std::span<const glm::uvec3> triangles) {
    return first_hit(ray, vertices, triangles, [](const RayHit&) { return true; });
}

} // namespace lineatlas
