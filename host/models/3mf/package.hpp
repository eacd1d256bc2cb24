#pragma once

#include <string_view>

namespace lineatlas::threemf {

/// Looks at a 3MF file's archive before lib3mf believes it. Refuses what is no ZIP archive, what
/// would unpack to far more than any model packs into its size, and by name every extension that a
/// model in it requires and that is not read. Throws std::runtime_error.
void check_package(std::string_view file);

} // namespace lineatlas::threemf
