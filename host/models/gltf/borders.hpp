#pragma once

#include <vector>

#include "primitives.hpp"

namespace lineatlas::gltf {

/// Where primitives of a mesh abut, takes a corner of the later one to that of the earlier one that
/// their rounding has parted: each may lie on a grid of its own (Draco, quantised accessors).
/// Corners on borders alone are moved, by no more than half a step of both grids in each direction,
/// and two corners of a primitive never to one place. What lies on no grid stays.
void join_borders(std::vector<Primitive>& primitives);

} // namespace lineatlas::gltf
