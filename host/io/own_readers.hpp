#pragma once

#include <string_view>

#include "core/progress.hpp"
#include "material_files.hpp"
#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Reads a model in memory by the readers that need no other library: those of OBJ, PLY, STL and
/// OFF. extension: one of these types, in lower case, with its dot. Throws FileError at the first
/// error, and Cancelled.
Soup read_own(SourceFile model, std::string_view extension, const MaterialFiles& materials,
              const ProgressPart& progress);

/// Whether read_own() reads files of that type.
bool has_own_reader(std::string_view extension);

} // namespace lineatlas
