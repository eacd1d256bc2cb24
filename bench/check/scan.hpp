#pragma once

#include <filesystem>

namespace lineatlas::bench {

/// Writes a closed surface with the noise of a scan as an OBJ file: a lobed ring of 80,000
/// triangles, rough by less than a thousandth of its size. The file is the same on every machine.
void write_scan(const std::filesystem::path& path);

} // namespace lineatlas::bench
