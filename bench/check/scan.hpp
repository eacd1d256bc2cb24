#pragma once

#include <filesystem>

namespace lineatlas::bench {

/// Writes a closed surface as scanners leave it, as OBJ: 80,000 triangles of a lobed ring, rough by
/// less than a thousandth of its size. The same on every machine.
void write_scan(const std::filesystem::path& path);

} // namespace lineatlas::bench
