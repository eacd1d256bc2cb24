#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/export.hpp"
#include "lineatlas/style.hpp"

/// @file
/// Styles by name, from files and to files.
/// @code{.cpp}
/// Style pencil = load_style("pencil"); // or the path of a TOML file
/// apply_setting(pencil, "width=3");
/// std::ofstream{"mine.toml"} << write_style(pencil, "Soft pencil");
/// @endcode

namespace lineatlas {

/// A style of lineatlas by its name, or a TOML file by its path (docs/styles.md). Image files of
/// pens are looked for beside the file that names them. Throws UsageError for an unknown name.
/// Throws FileError that names file, line and key for a file that cannot be read or has something
/// else than settings.
LINEATLAS_API Style load_style(const std::string& name_or_path);

/// The style of the tool if none is named: black lines, with lighter creases and heavier outlines,
/// whose widths grow with the picture. Its name is "plain".
LINEATLAS_API Style default_style();

/// Changes one setting, as in "width=3" or "color=#204060". Throws UsageError.
LINEATLAS_API void apply_setting(Style& style, std::string_view key_is_value);

/// A style as a TOML file: every key with its value and its purpose. The file loads as the same
/// style.
LINEATLAS_API std::string write_style(const Style& style, std::string_view description = {});

/// A style to choose from.
struct StyleInfo {
    std::string name;        ///< what load_style() takes
    std::string description; ///< one line
};

/// The styles of lineatlas, or those in the folder LINEATLAS_STYLE_DIR if that is set, sorted by
/// name.
LINEATLAS_API std::vector<StyleInfo> list_styles();

} // namespace lineatlas
