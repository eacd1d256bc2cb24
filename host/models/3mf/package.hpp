#pragma once

#include <string_view>

namespace lineatlas::threemf {

/// Checks the archive of a 3MF file before lib3mf reads it. Refuses a file that is no ZIP archive,
/// an archive that would unpack to far more than a model of its size, and by name every required
/// extension that is not read. Throws std::runtime_error.
void check_package(std::string_view file);

} // namespace lineatlas::threemf
