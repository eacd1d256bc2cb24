#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Removes parts of paths that would be drawn twice, because they run along another path, or along
/// an earlier part of their own path, within a quarter of a pixel. Visible lines stay before hidden
/// ones; then file, boundary, material, crease and silhouette, in the order in which an edge that
/// qualifies as several takes its kind (lines.hpp); then nearer ones, then earlier ones.
///
/// `curves`: PathCurves::numbers(). Of several lines along one curve the one with the longest
/// visible part stays; otherwise crumbs of one circle, beside the chords of another, would cut that
/// one up.
std::vector<VectorPath> remove_overlaps(std::vector<VectorPath> paths, glm::dvec2 picture,
                                        std::span<const std::uint32_t> curves = {});

} // namespace lineatlas
