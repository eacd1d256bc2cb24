#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lineatlas/style.hpp"
#include "setting.hpp"

namespace lineatlas {

/// Sets a key of a rule's pen. `key`: the key of a setting of the pen, or "width-factor". Throws
/// UsageError for any other key, and for a wrong value.
void set_pen_key(PenRule& rule, std::string_view key, const SettingValue& value);

/// The setting of the style's own pen with that key; throws UsageError that lists the keys of
/// rules.
const SettingOf<Style>& pen_setting(std::string_view key);

/// Sets what a rule asks of a line: "kind" (of which there may be several), "object" or "material"
/// by texts, "hidden" by true or false. Throws UsageError for another key or value, an unknown
/// kind, and hidden outlines.
void set_match_key(PenMatch& match, std::string_view key,
                   const std::variant<bool, std::vector<std::string>>& value);

/// Throws UsageError for a rule of the style by whose number it goes that says what no style file
/// can, or makes a pen that none can have.
void check_rule(const Style& style, std::size_t number);

/// What a rule says of its pen, by the keys that set_pen_key() takes.
std::vector<std::pair<std::string, SettingValue>> pen_values(const PenRule& rule);

/// The rules as the end of a style file; empty if there are none.
std::string pens_to_toml(const std::vector<PenRule>& rules);

} // namespace lineatlas
