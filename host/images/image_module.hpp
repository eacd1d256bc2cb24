#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/io.hpp"

namespace lineatlas::images {

/// What a module for pictures offers: lineatlas-png, which has the one type that most drawings
/// become, and lineatlas-images for all others, which alone links OpenImageIO, whose some 340
/// libraries take longer to load than a picture to draw.
/// Whatever is refused ends in a std::runtime_error that says the cause in one line.
struct Module {
    bool (*can_write)(const std::string& extension); ///< with its dot
    /// `file`: what the file `path` holds; nothing is opened.
    Image (*decode)(const std::filesystem::path& path, std::string_view file);
    /// What the file `path` should hold; nothing is written.
    std::vector<unsigned char> (*encode)(const std::filesystem::path& path, const Pixels& pixels,
                                         const ImageSettings& settings);
};

/// The module's one symbol. Its number changes with `Module`.
inline constexpr const char* module_symbol = "lineatlas_images_3";

} // namespace lineatlas::images

extern "C" const lineatlas::images::Module lineatlas_images_3;
