#pragma once

#include <string_view>

#include "assembly.hpp"

namespace lineatlas::brep {

/// Reads Open CASCADE's own files of shapes, which have no names, colours or units. Throws
/// std::runtime_error and exceptions of Open CASCADE.
Assembly read_brep(std::string_view file);

} // namespace lineatlas::brep
