#pragma once

#include "core/progress.hpp"
#include "material_files.hpp"
#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Reads OBJ text with its groups, materials and `l` elements through tinyobjloader. Throws
/// FileError with the line for anything that would otherwise be read as zero or as another vertex,
/// and Cancelled.
Soup read_obj(SourceFile source, const MaterialFiles& files, const ProgressPart& progress);

} // namespace lineatlas
