#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lineatlas/style.hpp"
#include "setting.hpp"

namespace lineatlas {

/// One member of Style.
using Setting = SettingOf<Style>;

/// The one table of them, in the order in which people read it.
std::span<const Setting> settings();

/// Throws UsageError with the nearest key.
const Setting& find_setting(std::string_view key);

/// Throws UsageError for the first member that is not what its setting may be, of the style or of
/// what a rule for pens makes of its pen. Allocates nothing for a style without rules.
void check_style(const Style& style);

/// All settings as a Markdown table; it stands in docs/styles.md.
std::string settings_table();

} // namespace lineatlas
