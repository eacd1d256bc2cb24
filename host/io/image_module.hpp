#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/io.hpp"

namespace lineatlas::images {

/// The functions of a module for pictures. lineatlas-png has the type of most drawings;
/// lineatlas-images has all other types. Only the latter links OpenImageIO, because its 340 or so
/// libraries take longer to load than a picture takes to draw. Every refusal is a
/// std::runtime_error that says the cause in one line.
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
