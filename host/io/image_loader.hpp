#pragma once

#include <filesystem>
#include <string_view>

#include "io/image_module.hpp"

namespace lineatlas {

/// One of the modules for pictures. They differ a hundredfold in the size of the libraries that
/// they load.
enum class PictureType {
    png, ///< lineatlas-png
    any  ///< lineatlas-images if it is installed, else lineatlas-png
};

PictureType type_by_name(const std::filesystem::path& path);
/// The type of a file by its content, because its name may be wrong.
PictureType type_by_content(std::string_view file);

/// The module for pictures of a type, loaded when first asked for. Throws FileError if it cannot be
/// loaded.
const images::Module& image_module(PictureType type);

/// Throws FileError unless the module is where it should be. Loads nothing.
void check_image_module(PictureType type);

} // namespace lineatlas
