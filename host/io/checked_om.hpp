#pragma once

#include <cstddef>
#include <string>

#include "source_file.hpp"

namespace lineatlas {

/// An OM file, checked from end to end and converted to the one narrow form that OpenMesh's reader
/// reads right.
struct CheckedOm {
    std::string bytes;        ///< for OpenMesh
    std::size_t vertices = 0; ///< that OpenMesh has to find
    std::size_t faces = 0;    ///< that OpenMesh has to find
};

/// Throws FileError at the first thing that is wrong, a missing end included.
CheckedOm check_om(const SourceFile& source);

} // namespace lineatlas
