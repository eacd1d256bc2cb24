#pragma once

#include <filesystem>
#include <optional>

#include <toml++/toml.h>

#include "lineatlas/style.hpp"
#include "setting.hpp"

namespace lineatlas {

/// A TOML file, with limits on its size and depth. Throws FileError that names the file and, if
/// there is one, the line.
toml::table read_toml(const std::filesystem::path& file);

/// Nothing for what no setting can be: tables, dates and mixed lists.
std::optional<SettingValue> value_of(const toml::node& node);

/// The style that is a table of a file; image files of pens stand beside it. Throws FileError,
/// naming file, line and key.
Style style_of(const toml::table& table, const std::filesystem::path& file);

} // namespace lineatlas
