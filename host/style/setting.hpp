#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lineatlas/error.hpp"

namespace lineatlas {

/// A value from a file or a command line, before it is assigned to a member.
using SettingValue = std::variant<bool, double, std::string, std::vector<double>>;

/// One member of a struct that people set by name: the key of files, with "--" before it the option
/// of the tool, with "_" for "-" the argument in Python.
template <class Struct>
struct SettingOf {
    std::string key;
    std::string values; ///< the allowed values, to follow "must be"
    std::string help;   ///< one line
    bool flag;          ///< true or false
    std::function<SettingValue(const Struct&)> get;
    /// Whether the member has an allowed value. A program may have set it to any.
    std::function<bool(const Struct&)> holds;
    /// Sets the member. Returns false, and changes nothing, for a value of another type or out of
    /// range.
    std::function<bool(Struct&, const SettingValue&)> set;
    std::vector<std::string> names{}; ///< the words to choose from, if any
    bool is_mark = false;             ///< may be the name of an image file
};

/// An error that says that `value` is not what `called` must be: `values`, perhaps one of `names`.
UsageError wrong_value(std::string_view called, std::string_view values,
                       const std::vector<std::string>& names, const SettingValue& value);

/// Sets a value. Throws UsageError that starts with `called`, which is the user's text for the key.
template <class Struct>
void set_value(Struct& object, const SettingOf<Struct>& setting, const SettingValue& value,
               std::string_view called) {
    if (!setting.set(object, value))
        throw wrong_value(called, setting.values, setting.names, value);
}

/// Throws UsageError, in the same words, for a member without an allowed value. `of`: text before
/// the key.
template <class Struct>
void check_member(const Struct& object, const SettingOf<Struct>& setting, std::string_view of) {
    if (!setting.holds(object))
        throw wrong_value(std::string{of} + setting.key, setting.values, {}, setting.get(object));
}

/// An error that says that no setting has this key. It names the nearest of `keys`, or else
/// `listed_by`, the command that lists them.
UsageError wrong_key(std::string_view key, const std::vector<std::string>& keys,
                     std::string_view listed_by);

/// Throws UsageError.
template <class Struct>
const SettingOf<Struct>& find_setting(std::span<const SettingOf<Struct>> table,
                                      std::string_view key, std::string_view listed_by) {
    std::vector<std::string> keys;
    for (const SettingOf<Struct>& setting : table) {
        if (setting.key == key) return setting;
        keys.push_back(setting.key);
    }
    throw wrong_key(key, keys, listed_by);
}

/// "true", "2", "1,0.5" or any other word; brackets and quotes as in TOML are taken too.
SettingValue value_from_text(std::string_view text);

/// The value as TOML.
std::string value_to_toml(const SettingValue& value);

/// The head of a Markdown table of settings, and a row of it.
inline constexpr const char* settings_table_head =
    "| key | what it does | default | must be |\n|---|---|---|---|\n";
std::string settings_table_row(std::string_view key, std::string_view help,
                               const SettingValue& value, std::string_view values);

/// The settings as a Markdown table, with the values of `defaults`.
template <class Struct>
std::string markdown_table(std::span<const SettingOf<Struct>> table, const Struct& defaults) {
    std::string text = settings_table_head;
    for (const SettingOf<Struct>& setting : table) {
        text +=
            settings_table_row(setting.key, setting.help, setting.get(defaults), setting.values);
    }
    return text;
}

/// `; did you mean "..."?` with the element of `known` nearest to `word`; empty if none is near.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

} // namespace lineatlas
