#pragma once

#include <algorithm>

#include <glm/geometric.hpp>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The distance within which a point touches a plane, as a share of the model's diagonal: the
/// precision of coordinates as floats.
inline constexpr double contact_share = 2e-6;

/// How far apart two things of a model may be that touch each other: `precision` is
/// Mesh::precision, by which each of the two may be off.
inline double contact_of(double diagonal, double precision) {
    return std::max(contact_share * diagonal, 2 * precision);
}
inline float contact_of(const LineSet& lines) {
    return static_cast<float>(
        contact_of(glm::distance(lines.bounds.min, lines.bounds.max), lines.precision));
}

} // namespace lineatlas
