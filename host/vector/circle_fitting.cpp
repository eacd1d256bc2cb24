#include "circle_fitting.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace lineatlas {
namespace {

/// The circle with the least squares of a point's power: near to the best, and needs no start.
std::optional<Circle> rough_circle(std::span<const glm::dvec2> points) {
    glm::dvec2 mean{0};
    for (const glm::dvec2& point : points) mean += point;
    mean /= static_cast<double>(points.size());
    glm::dmat3 normal{0};
    glm::dvec3 right{0};
    for (const glm::dvec2& point : points) {
        const glm::dvec2 at = point - mean;
        const glm::dvec3 row{at, 1};
        normal += glm::outerProduct(row, row);
        right += row * glm::dot(at, at);
    }
    const double size = normal[0][0] + normal[1][1];
    if (!(std::abs(glm::determinant(normal)) > 1e-12 * size * size)) return std::nullopt;
    const glm::dvec3 found = glm::inverse(normal) * right;
    const glm::dvec2 center = 0.5 * glm::dvec2{found};
    const double squared = found.z + glm::dot(center, center);
    if (!(squared > 0)) return std::nullopt;
    return Circle{mean + center, std::sqrt(squared)};
}

} // namespace

std::optional<Circle> fit_circle(std::span<const glm::dvec2> points) {
    std::optional<Circle> circle = rough_circle(points);
    constexpr int rounds = 3;
    for (int round = 0; circle && round < rounds; ++round) {
        glm::dmat3 normal{0};
        glm::dvec3 right{0};
        for (const glm::dvec2& point : points) {
            const glm::dvec2 out = point - circle->center;
            const double length = glm::length(out);
            if (!(length > 0)) return std::nullopt;
            const glm::dvec3 row{out / length, 1};
            normal += glm::outerProduct(row, row);
            right += row * (length - circle->radius);
        }
        if (!(std::abs(glm::determinant(normal)) > 1e-12)) return std::nullopt;
        const glm::dvec3 change = glm::inverse(normal) * right;
        circle->center += glm::dvec2{change};
        circle->radius += change.z;
    }
    return circle;
}

} // namespace lineatlas
