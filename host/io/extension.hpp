#pragma once

#include <filesystem>
#include <string>

#include "core/up_axis.hpp"

namespace lineatlas {

/// The extension of a file's name with its dot, in lower case: ".obj"; empty if it has none.
std::string lower_extension(const std::filesystem::path& path);

/// What is upwards in most models of a file's kind: z in STL, which printers and machines read.
UsualUp usual_up(const std::filesystem::path& model);

} // namespace lineatlas
