#pragma once

#include <string_view>

#include "assembly.hpp"

namespace lineatlas::brep {

/// Reads Open CASCADE's own files of shapes, which have no names, colours and units. Throws
/// std::runtime_error, or what Open CASCADE throws.
Assembly read_brep(std::string_view file);

} // namespace lineatlas::brep
