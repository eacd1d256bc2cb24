#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Removes parts of paths that would be drawn twice, because they run along another path, or along
/// an earlier part of their own path, within a quarter of a pixel. Visible lines stay before hidden
/// ones, then kinds in the order that docs/vector.md gives, then nearer lines, then earlier ones.
///
/// `curves`: PathCurves::numbers(). Of several lines along one curve the line with the longest
/// visible part stays. Otherwise crumbs of one circle would cut up another circle beside them.
std::vector<VectorPath> remove_overlaps(std::vector<VectorPath> paths, glm::dvec2 picture,
                                        std::span<const std::uint32_t> curves = {});

} // namespace lineatlas
