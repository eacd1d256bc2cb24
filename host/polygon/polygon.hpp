#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// Appends the triangles of one polygon to `triangles`, in the polygon's orientation.
///
/// `polygon` holds at least 3 indices into `positions`. A simple polygon gives corners - 2
/// triangles that cover it without overlap, also when it is concave or when corners lie on a
/// straight line; a polygon that crosses itself gives the same number of triangles, which may
/// overlap. Non-planar polygons are judged by their projection along the Newell normal. Corners
/// with equal indices (a hole joined to the outline by a bridge) are allowed; triangles that would
/// repeat an index are left out.
void triangulate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> polygon,
                 std::vector<glm::uvec3>& triangles);

} // namespace lineatlas
