#pragma once

#include <algorithm>

#include <glm/geometric.hpp>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The distance within which a point touches a plane, as a share of the model's diagonal: the
/// precision of coordinates as floats.
inline constexpr double contact_share = 2e-6;

/// The largest distance between two things of a model that touch each other. Each of the two may be
/// off by `precision` (Mesh::precision).
inline double contact_of(double diagonal, double precision) {
    return std::max(contact_share * diagonal, 2 * precision);
}
inline float contact_of(const LineSet& lines) {
    return static_cast<float>(
        contact_of(glm::distance(lines.bounds.min, lines.bounds.max), lines.precision));
}

} // namespace lineatlas
