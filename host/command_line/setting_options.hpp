#pragma once

#include <map>
#include <span>
#include <string>
#include <variant>

#include <CLI/App.hpp>

#include "style/setting.hpp"

namespace lineatlas {

/// An option for every setting of a table.
template <class Struct>
class SettingOptions {
  public:
    /// `app` must outlive this object, and this object the parsing. `defaults`: the values without
    /// options, for --help.
    void declare(CLI::App& app, std::span<const SettingOf<Struct>> table, const Struct& defaults,
                 const std::string& group) {
        app_ = &app;
        table_ = table;
        for (const SettingOf<Struct>& setting : table) {
            std::string& value = values_[setting.key];
            const std::string help = setting.help + ": " + setting.values;
            if (setting.flag) {
                app.add_flag("--" + setting.key, value, help)->group(group);
            } else {
                app.add_option("--" + setting.key, value, help)
                    ->default_str(shown(setting.get(defaults)))
                    ->group(group);
            }
        }
    }

    /// Sets what was given. Throws UsageError that names the option.
    void apply(Struct& object) const {
        for (const SettingOf<Struct>& setting : table_) {
            const std::string option = "--" + setting.key;
            if (app_->count(option) == 0) continue;
            set_value(object, setting, value_from_text(values_.at(setting.key)), option);
        }
    }

  private:
    static std::string shown(const SettingValue& value) {
        const auto* word = std::get_if<std::string>(&value);
        return word != nullptr ? *word : value_to_toml(value);
    }

    const CLI::App* app_ = nullptr;
    std::span<const SettingOf<Struct>> table_;
    std::map<std::string, std::string> values_; ///< by key, as written
};

} // namespace lineatlas
