#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lineatlas {

/// A plane with axes of its own. Along an axis of the model they are the other two axes.
struct PlaneFrame {
    glm::dvec3 origin, normal, u, v;

    /// `normal` need not be of length 1, but must have one.
    PlaneFrame(glm::dvec3 point, glm::dvec3 direction);

    double distance(glm::dvec3 at) const { return glm::dot(at - origin, normal); }
    glm::dvec2 flat(glm::dvec3 at) const {
        return {glm::dot(at - origin, u), glm::dot(at - origin, v)};
    }
    /// The place that is nearest, exactly on the plane if that lies along an axis.
    glm::vec3 placed(glm::dvec3 at) const;
    glm::vec3 space(glm::dvec2 at) const { return placed(origin + at.x * u + at.y * v); }
};

} // namespace lineatlas
