#pragma once

#include <string_view>

#include "assembly.hpp"

namespace lineatlas::brep {

/// Makes Open CASCADE's tables for STEP, which takes a while and reads the environment.
void prepare_step();

/// Reads a STEP file of any application protocol, in millimetres, whatever its unit is. Throws
/// std::runtime_error and exceptions of Open CASCADE.
Assembly read_step(std::string_view file);

} // namespace lineatlas::brep
