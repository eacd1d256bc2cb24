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

/// Several models as one, each where its own coordinates place it, but upright: one that says
/// another upward axis than the first that says one is turned by a quarter, with a note. Each is a
/// part of its name that holds the parts of its file. Lengths are in the first unit that a file
/// says; files of another one are scaled to it, with a note. Where some files say what their edges
/// are (KnownEdge), the creases and boundaries of the others are those of extract_lines() without
/// options.
LoadedMesh join_models(std::vector<NamedModel> models);

/// load_mesh_isolated() of a file; of several that, joined. Where their upward axes differ, said or
/// usual for their types, all of them say theirs. Two files of one name are told apart by
/// a number.
LoadedMesh load_models_isolated(std::span<const std::filesystem::path> files,
                                const ReadLimits& limits = {}, const LoadOptions& options = {});

} // namespace lineatlas
