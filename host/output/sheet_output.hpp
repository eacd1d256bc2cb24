#pragma once

#include <filesystem>

#include "lineatlas/io.hpp"
#include "lineatlas/sheet.hpp"

namespace lineatlas {

/// Writes a sheet as SVG, DXF or PDF, or for other extensions as a picture with the resolution of
/// `picture`. The file appears whole or not at all. Throws UsageError and FileError.
void write_sheet(const std::filesystem::path& path, const VectorSheet& sheet,
                 const SheetWriting& writing, const ImageSettings& picture);

} // namespace lineatlas
