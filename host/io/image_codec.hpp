#pragma once

#include <filesystem>
#include <vector>

#include "lineatlas/io.hpp"
#include "source_file.hpp"

namespace lineatlas {

// read_image() and write_image() without their files. Once the module is loaded, these open
// nothing.

/// Throws FileError.
Image decode_image(const SourceFile& file);

/// The content of the file `path`. Throws FileError.
std::vector<unsigned char> encode_image(const std::filesystem::path& path, const Pixels& pixels,
                                        const ImageSettings& settings);

} // namespace lineatlas
