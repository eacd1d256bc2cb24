#pragma once

#include <vector>

#include "io/model_module.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Reads the files that a glTF or GLB model names as its buffers, as far as NamedFiles does. What
/// could not be read is missing in the list. Looks for names only, and believes nothing else:
/// pictures are left out by their extension.
std::vector<models::NamedFile> read_gltf_files(const SourceFile& model);

} // namespace lineatlas
