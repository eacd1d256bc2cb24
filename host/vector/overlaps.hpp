#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Cuts away what would be drawn twice: parts of paths that run along another one, or along an
/// earlier part of themselves, within a quarter of a pixel. Visible lines stay before hidden ones;
/// then file, boundary, material, crease and silhouette, in the order in which an edge that
/// qualifies as several takes its kind (lines.hpp); then nearer ones, then earlier ones.
///
/// `curves`: PathCurves::numbers(). Of several lines along one curve the one of which most is seen
/// stays: chords of one circle leave crumbs of another, which must not cut it up.
std::vector<VectorPath> remove_overlaps(std::vector<VectorPath> paths, glm::dvec2 picture,
                                        std::span<const std::uint32_t> curves = {});

} // namespace lineatlas
