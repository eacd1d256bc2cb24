#pragma once

#include <cstddef>
#include <string>

#include "source_file.hpp"

namespace lineatlas {

/// An OM file, checked from end to end and converted to the narrow form that OpenMesh's reader
/// reads correctly.
struct CheckedOm {
    std::string bytes;        ///< for OpenMesh
    std::size_t vertices = 0; ///< that OpenMesh has to find
    std::size_t faces = 0;    ///< that OpenMesh has to find
};

/// Checks and converts an OM file. Throws FileError at the first error, a missing end included.
CheckedOm check_om(const SourceFile& source);

} // namespace lineatlas
