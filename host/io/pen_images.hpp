#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "lineatlas/io.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// Reads the pictures of pens whose marks are image files, by the names of the marks. Leaves out
/// `known` marks. Throws FileError.
std::map<std::string, Image>
read_pen_images(const Style& style, const std::set<std::string>& known = {},
                const std::function<Image(const std::filesystem::path&)>& read = read_image);

} // namespace lineatlas
