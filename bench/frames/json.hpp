#pragma once

#include <filesystem>

#include "report.hpp"

namespace lineatlas::bench {

/// {"device", "gl", "size", "scenes": {name: {"triangles", "segments", "methods": {name: {"ms",
/// "fps", "stages": {}, "frames"}}, "depth": {"1x": as a method, "2x": ...}}}, "goals": [...]}.
/// Methods that could not be measured are missing. The file appears whole or not at all. Throws
/// FileError.
void write_json(const std::filesystem::path& path, const Report& report);

} // namespace lineatlas::bench
