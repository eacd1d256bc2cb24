#pragma once

#include <vector>

#include "primitives.hpp"

namespace lineatlas::gltf {

/// Closes gaps that rounding has made between abutting primitives of a mesh, each of which may lie
/// on a grid of its own (Draco, quantised accessors): moves a corner of the later primitive to the
/// corner of the earlier one. Only corners on borders are moved, by no more than half a step of
/// both grids in each direction, and two corners of a primitive never to one place. Primitives that
/// lie on no grid do not change.
void join_borders(std::vector<Primitive>& primitives);

} // namespace lineatlas::gltf
