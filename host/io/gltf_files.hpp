#pragma once

#include <vector>

#include "io/model_module.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Reads the files that a glTF or GLB model names as its buffers, as far as NamedFiles allows.
/// Files that could not be read are missing in the list. The function looks only for names in the
/// model and trusts nothing else there. It leaves out pictures, by their extension.
std::vector<models::NamedFile> read_gltf_files(const SourceFile& model);

} // namespace lineatlas
