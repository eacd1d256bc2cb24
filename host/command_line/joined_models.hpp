#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/isolated.hpp"

namespace lineatlas {

/// The largest number of files that make one scene.
inline constexpr std::size_t most_models = 100;

struct NamedModel {
    std::string name;
    LoadedMesh loaded;
};

/// Joins several models to one. Each stands where its own coordinates place it, but upright: a
/// model with another upward axis than the first that says one is turned by a quarter, with a note.
/// Each model is a part with its name that holds the parts of its file. Lengths are in the first
/// unit that a file says; files with another unit are scaled to it, with a note. If some files say
/// what their edges are (KnownEdge), the other files get the creases and boundaries of
/// extract_lines() without options.
LoadedMesh join_models(std::vector<NamedModel> models);

/// Reads one file by load_mesh_isolated(), or reads and joins several. If the upward axes of the
/// files or of their types differ, each model keeps its own. Files with the same name are told
/// apart by a number.
LoadedMesh load_models_isolated(std::span<const std::filesystem::path> files,
                                const ReadLimits& limits = {}, const LoadOptions& options = {});

} // namespace lineatlas
