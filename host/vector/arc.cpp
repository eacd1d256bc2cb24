#include <cmath>

#include "lineatlas/vector.hpp"

namespace lineatlas {

glm::dvec2 VectorArc::at(double angle) const {
    const glm::dvec2 minor = ratio * glm::dvec2{-major.y, major.x};
    return center + std::cos(angle) * major + std::sin(angle) * minor;
}

} // namespace lineatlas
