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

/// Reads the files that each `mtllib` of `obj` names. Only regular files beside the OBJ file or
/// below its folder are read, wherever links lead, so that a stranger's model cannot find out about
/// other files on this machine.
MaterialFiles read_material_files(const SourceFile& obj);

} // namespace lineatlas
