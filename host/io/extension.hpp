#pragma once

#include <filesystem>
#include <string>

namespace lineatlas {

/// The extension of a file's name with its dot, in lower case: ".obj"; empty if it has none.
std::string lower_extension(const std::filesystem::path& path);

} // namespace lineatlas
