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

/// The setting of the style's own pen with this key. Throws UsageError that lists the keys of
/// rules.
const SettingOf<Style>& pen_setting(std::string_view key);

/// Sets a condition of a rule: "kind" (several are allowed), "object" or "material" by texts,
/// "hidden" by true or false. Throws UsageError for another key or value, an unknown kind, and
/// hidden outlines.
void set_match_key(PenMatch& match, std::string_view key,
                   const std::variant<bool, std::vector<std::string>>& value);

/// Throws UsageError if rule `number` of the style has a value that no style file can have, or
/// makes a pen that none can have.
void check_rule(const Style& style, std::size_t number);

/// The changes of a rule to its pen, with the keys of set_pen_key().
std::vector<std::pair<std::string, SettingValue>> pen_values(const PenRule& rule);

/// The rules as the end of a style file; empty if there are none.
std::string pens_to_toml(const std::vector<PenRule>& rules);

} // namespace lineatlas
