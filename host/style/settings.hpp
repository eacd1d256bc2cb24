#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lineatlas/style.hpp"

namespace lineatlas {

/// A value as it stands in a file or on a command line, before it is a member's.
using SettingValue = std::variant<bool, double, std::string, std::vector<double>>;

/// One member of Style: the key of style files and, with "--" before it, the option of the tool.
struct Setting {
    std::string key;
    std::string values; ///< what there is, to follow "must be"
    std::string help;   ///< one line
    bool flag;          ///< true or false
    std::function<SettingValue(const Style&)> get;
    /// False for a value of another type or out of range; the style is then unchanged.
    std::function<bool(Style&, const SettingValue&)> set;
    std::vector<std::string> names{}; ///< where there is a choice of words
    bool is_mark = false;             ///< may be the name of an image file
};

/// The one table of them, in the order in which people read it.
std::span<const Setting> settings();

/// Throws UsageError with the nearest key.
const Setting& find_setting(std::string_view key);

/// Throws UsageError that starts with `called`: what the user wrote for the key.
void set_value(Style& style, const Setting& setting, const SettingValue& value,
               std::string_view called);

/// "true", "2", "1,0.5" or any other word; brackets and quotes as in TOML are taken too.
SettingValue value_from_text(std::string_view text);

/// As TOML has it.
std::string value_to_toml(const SettingValue& value);

/// All settings as a Markdown table; it stands in docs/styles.md.
std::string settings_table();

/// The member of `known` that `word` may have been meant to be, as `; did you mean "..."?`; empty
/// if none is near.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

} // namespace lineatlas
