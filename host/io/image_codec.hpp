#pragma once

#include <filesystem>
#include <vector>

#include "lineatlas/io.hpp"
#include "source_file.hpp"

namespace lineatlas {

// read_image() and write_image() without their files. Where the module is loaded they open nothing.

/// Throws FileError.
Image decode_image(const SourceFile& file);

/// What the file `path` is to hold. Throws FileError.
std::vector<unsigned char> encode_image(const std::filesystem::path& path, const Pixels& pixels,
                                        const ImageSettings& settings);

} // namespace lineatlas
