#pragma once

#include <filesystem>

namespace lineatlas::fuzz {

/// Loads a mesh and extracts its lines. Expects that the mesh is sound, or refused in one line.
void try_mesh(const std::filesystem::path& path);

} // namespace lineatlas::fuzz
