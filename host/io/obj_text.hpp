#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "source_file.hpp"

namespace lineatlas {

/// OBJ text, reduced to the elements that tinyobjloader reads correctly. tinyobjloader takes a word
/// that is no number for zero, reads only floats, takes a comment behind a face for more corners,
/// and has no `l` elements in its callback interface.
struct ObjText {
    std::string text; ///< v, f, o, g and usemtl; one line for each in the file
    /// The positions of the v lines, which are all zeros in `text`.
    std::vector<glm::dvec3> positions;
    std::vector<std::size_t> polyline_ends; ///< ends of those f lines in `text` that were l lines
};

/// Reduces an OBJ file. Throws FileError, with the line, for a `v` without three numbers, for a
/// corner that is no index, and for text that is no OBJ at all.
ObjText reduce_obj(const SourceFile& source);

} // namespace lineatlas
