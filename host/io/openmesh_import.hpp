#pragma once

#include <filesystem>

#include "checked.hpp"
#include "soup.hpp"

namespace lineatlas {

/// Lets OpenMesh's own reader for `extension` (".ply", ".stl", ".off" or ".om") read checked bytes
/// into a soup instead of a halfedge mesh, which would drop or split faces at non-manifold edges.
/// Throws FileError when it does not find what the check counted. `path` is for messages.
Soup import_by_openmesh(CheckedMesh checked, std::string_view extension,
                        const std::filesystem::path& path);

} // namespace lineatlas
