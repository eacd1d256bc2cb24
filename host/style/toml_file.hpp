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

/// The value of a node; nothing for tables, dates and mixed lists, which no setting can be.
std::optional<SettingValue> value_of(const toml::node& node);

/// The style in a table of a file. Image files of pens stand beside the file. Throws FileError that
/// names file, line and key.
Style style_of(const toml::table& table, const std::filesystem::path& file);

} // namespace lineatlas
