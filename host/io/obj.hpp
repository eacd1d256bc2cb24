#pragma once

#include "core/progress.hpp"
#include "material_files.hpp"
#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Reads OBJ text with its groups, materials and `l` elements. Throws FileError with its line for a
/// `v` without three numbers and for a corner that is no vertex of the file, and Cancelled.
Soup read_obj(const SourceFile& source, const MaterialFiles& files, const ProgressPart& progress);

} // namespace lineatlas
