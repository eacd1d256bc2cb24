#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "source_file.hpp"

namespace lineatlas {

/// A mesh file walked from end to end and brought to the one narrow form that OpenMesh's reader of
/// its type gets right. The readers trust headers, stop silently at the end of a file, and lose
/// their place at comments, `nan`, lists and colours they do not know; each check_* function says
/// which.
struct CheckedMesh {
    std::string bytes;                ///< for OpenMesh
    std::size_t vertices = 0;         ///< that OpenMesh has to find; 0 for STL, which has no count
    std::size_t faces = 0;            ///< that OpenMesh has to find
    std::size_t not_finite_faces = 0; ///< left out of `bytes`
    /// The vertices as the file has them, where OpenMesh's floats can't hold them; else empty.
    std::vector<glm::dvec3> exact{};
    glm::dvec3 origin{0};             ///< taken off all vertices
    std::vector<std::string> notes{}; ///< what the user should know
};

/// Each throws FileError at the first thing that is wrong, a missing end included.
CheckedMesh check_ply(const SourceFile& source);
CheckedMesh check_stl(const SourceFile& source);
CheckedMesh check_off(const SourceFile& source);
CheckedMesh check_om(const SourceFile& source);

} // namespace lineatlas
