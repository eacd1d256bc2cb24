#include "surface_triangle.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "surface/surface_point.hpp"

namespace lineatlas {

SurfaceTriangle::SurfaceTriangle(const KnownSurfaces& known, std::uint32_t triangle,
                                 const std::array<glm::dvec3, 3>& corners)
    : placed_(known.surfaces[known.of_triangle[triangle]]), shape_(known.shapes[placed_.shape]),
      parameters_(known.parameters[triangle]), corners_(corners),
      normal_turn_(glm::transpose(glm::inverse(glm::dmat3{glm::dmat4{placed_.model_from_shape}}))) {
    for (std::size_t k = 0; k < 3; ++k) {
        longest_ = std::max(longest_, glm::distance(corners_[k], corners_[(k + 1) % 3]));
        const SurfacePoint point = evaluate(shape_, parameters_[k]);
        if (point.normal != glm::dvec3{0}) continue;
        tip_ = k;
        free_ = glm::dot(point.u, point.u) <= glm::dot(point.v, point.v) ? 0 : 1;
    }
}

glm::dvec2 SurfaceTriangle::parameters(const glm::dvec3& shares) const {
    glm::dvec2 at =
        shares.x * parameters_[0] + shares.y * parameters_[1] + shares.z * parameters_[2];
    if (tip_ == none) return at;
    const double of_tip = shares[static_cast<int>(tip_)];
    if (of_tip < 1) at[free_] = (at[free_] - of_tip * parameters_[tip_][free_]) / (1 - of_tip);
    return at;
}

SurfaceTriangle::Place SurfaceTriangle::place(const glm::dvec3& shares) const {
    const SurfacePoint point = evaluate(shape_, parameters(shares));
    const glm::dvec3 flat =
        shares.x * corners_[0] + shares.y * corners_[1] + shares.z * corners_[2];
    const glm::dvec3 at = placed_.model_from_shape * glm::dvec4{point.at, 1};
    const glm::dvec3 normal = normal_turn_ * ((placed_.turned ? -1.0 : 1.0) * point.normal);
    const double length = glm::length(normal);
    return {glm::distance(at, flat) < longest_ ? at : flat, length > 0 ? normal / length : normal};
}

} // namespace lineatlas
