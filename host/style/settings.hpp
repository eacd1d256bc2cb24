#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lineatlas/style.hpp"
#include "setting.hpp"

namespace lineatlas {

/// One member of Style.
using Setting = SettingOf<Style>;

/// The one table of style settings, in the order for readers.
std::span<const Setting> settings();

/// The setting with this key. Throws UsageError that names the nearest key.
const Setting& find_setting(std::string_view key);

/// Throws UsageError for the first member of the style, or of a pen that a rule makes, with a value
/// that its setting does not allow. Allocates nothing for a style without rules.
void check_style(const Style& style);

/// All style settings as the Markdown table of docs/styles.md.
std::string settings_table();

} // namespace lineatlas
