#pragma once

#include <filesystem>
#include <vector>

#include "core/progress.hpp"
#include "io/model_module.hpp"
#include "lineatlas/io.hpp"
#include "material_files.hpp"
#include "source_file.hpp"

namespace lineatlas {

// load_mesh() in two steps: the first opens files, the second parses them.

/// All files that a model consists of.
struct MeshSource {
    SourceFile model;
    MaterialFiles materials;
    std::vector<models::NamedFile> named{}; ///< the files that a scene names
};

/// Reads the files, and loads the module that the type needs. Throws FileError for files that
/// cannot be read and for types that are no mesh.
MeshSource read_mesh_source(const std::filesystem::path& path);

/// Parses the files. Opens nothing. Throws FileError and Cancelled.
LoadedMesh parse_mesh(MeshSource source, const LoadOptions& options = {},
                      const ProgressPart& progress = ProgressPart::none());

} // namespace lineatlas
