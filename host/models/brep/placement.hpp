#pragma once

#include "assembly.hpp"
#include "io/soup.hpp"

namespace lineatlas::brep {

/// Meshes every shape once and puts its instances in their places. `deflection`: 0 is a thousandth
/// of the whole assembly's diagonal.
Soup place(Assembly&& assembly, double deflection);

} // namespace lineatlas::brep
