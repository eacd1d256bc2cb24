#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lineatlas {

/// A plane with axes of its own. If the normal is an axis of the model, they are the other two
/// axes.
struct PlaneFrame {
    glm::dvec3 origin, normal, u, v;

    /// `direction` may have any length above 0.
    PlaneFrame(glm::dvec3 point, glm::dvec3 direction);

    double distance(glm::dvec3 at) const { return glm::dot(at - origin, normal); }
    glm::dvec2 flat(glm::dvec3 at) const {
        return {glm::dot(at - origin, u), glm::dot(at - origin, v)};
    }
    /// The nearest place on the plane. It is exactly on the plane if the normal is an axis.
    glm::vec3 placed(glm::dvec3 at) const;
    glm::vec3 space(glm::dvec2 at) const { return placed(origin + at.x * u + at.y * v); }
};

} // namespace lineatlas
