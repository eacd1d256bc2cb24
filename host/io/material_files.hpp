#pragma once

#include <string>
#include <vector>

#include "source_file.hpp"

namespace lineatlas {

/// The material files that an OBJ file names, whole, in memory.
struct MaterialFiles {
    std::vector<std::string> contents; ///< in the order of the file
    std::vector<std::string> notes;    ///< one line for each that could not be read
};

/// Reads what follows each `mtllib` of `obj`. Only regular files beside the OBJ file or below its
/// folder, wherever links lead: a model that was sent by somebody says nothing about what else is
/// on this machine.
MaterialFiles read_material_files(const SourceFile& obj);

} // namespace lineatlas
