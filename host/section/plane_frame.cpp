#include "plane_frame.hpp"

#include <glm/common.hpp>

namespace lineatlas {

PlaneFrame::PlaneFrame(glm::dvec3 point, glm::dvec3 direction)
    : origin(point), normal(glm::normalize(direction)) {
    const glm::dvec3 size = glm::abs(normal);
    // The axis that stands up on paper: y, or -z if one looks along y.
    const glm::dvec3 up = size.y > 0.9 ? glm::dvec3{0, 0, -1} : glm::dvec3{0, 1, 0};
    u = glm::normalize(glm::cross(up, normal));
    v = glm::cross(normal, u);
}

glm::vec3 PlaneFrame::placed(glm::dvec3 at) const {
    glm::dvec3 place = at - distance(at) * normal;
    for (int axis = 0; axis < 3; ++axis)
        if (glm::abs(normal[axis]) == 1) place[axis] = origin[axis];
    return glm::vec3{place};
}

} // namespace lineatlas
