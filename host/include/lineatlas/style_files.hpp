#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/export.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// A style by the name of one that ships, or by the path of a TOML file (docs/styles.md). Image
/// files of pens are looked for beside the file that names them. Throws UsageError for an unknown
/// name; FileError, naming file, line and key, for a file that cannot be read or holds what is no
/// setting.
LINEATLAS_API Style load_style(const std::string& name_or_path);

/// What the tool draws with when no style is named: black lines, creases lighter and the outline
/// heavier, that grow with the picture. It ships by the name of "plain".
LINEATLAS_API Style default_style();

/// Changes one setting, as in "width=3" or "color=#204060". Throws UsageError.
LINEATLAS_API void apply_setting(Style& style, std::string_view key_is_value);

/// A style as a TOML file: every key, its value, and what it is for. Loads as the same style.
LINEATLAS_API std::string write_style(const Style& style, std::string_view description = {});

/// A style to choose from.
struct StyleInfo {
    std::string name;        ///< what load_style() takes
    std::string description; ///< one line
};

/// The styles that ship, or those of the folder in LINEATLAS_STYLE_DIR if that is set, by name.
LINEATLAS_API std::vector<StyleInfo> list_styles();

} // namespace lineatlas
