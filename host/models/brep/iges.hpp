#pragma once

#include <string_view>

#include "assembly.hpp"

namespace lineatlas::brep {

/// Makes Open CASCADE's tables for IGES, which takes a while and reads the environment.
void prepare_iges();

/// Reads an IGES file in millimetres, whatever its unit is. Only one file may be read at a time.
/// Throws std::runtime_error and exceptions of Open CASCADE.
Assembly read_iges(std::string_view file);

} // namespace lineatlas::brep
