#pragma once

#include <vector>

#include "primitives.hpp"

namespace lineatlas::gltf {

/// Closes gaps that rounding has made between abutting primitives of a mesh. Each primitive may lie
/// on a grid of its own (Draco, quantised accessors). A corner of the later primitive moves to the
/// corner of the earlier one. Only corners on borders move, by no more than half a step of both
/// grids in each direction, and two corners of a primitive never move to one place. Primitives
/// without a grid do not change.
void join_borders(std::vector<Primitive>& primitives);

} // namespace lineatlas::gltf
