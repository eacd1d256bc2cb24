#pragma once

#include <string_view>

#include "assembly.hpp"

namespace lineatlas::brep {

/// Makes Open CASCADE's tables for STEP, which take a while and look at the environment.
void prepare_step();

/// Reads a STEP file of any application protocol, in millimetres whatever its unit is. Throws
/// std::runtime_error, or what Open CASCADE throws.
Assembly read_step(std::string_view file);

} // namespace lineatlas::brep
