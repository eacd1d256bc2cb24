#pragma once

#include <string_view>

#include "assembly.hpp"

namespace lineatlas::brep {

/// Makes Open CASCADE's tables for IGES, which take a while and look at the environment.
void prepare_iges();

/// Reads an IGES file in millimetres whatever its unit is. Only one at a time may be read. Throws
/// std::runtime_error, or what Open CASCADE throws.
Assembly read_iges(std::string_view file);

} // namespace lineatlas::brep
