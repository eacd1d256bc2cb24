#pragma once

#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Reads OBJ text with its groups, materials and `l` elements through tinyobjloader. Materials come
/// from the files that `mtllib` names, beside the OBJ file; one that is missing is a note. Throws
/// FileError with the line for anything that would otherwise be read as zero or as another vertex.
Soup read_obj(SourceFile source);

} // namespace lineatlas
