#include "setting_options.hpp"

#include <variant>

#include <CLI/App.hpp>

#include "lineatlas/style.hpp"
#include "style/frame_settings.hpp"

namespace lineatlas {
namespace {

std::string shown(const SettingValue& value) {
    const auto* word = std::get_if<std::string>(&value);
    return word != nullptr ? *word : value_to_toml(value);
}

} // namespace

template <class Struct>
void SettingOptions<Struct>::declare(CLI::App& app, std::span<const SettingOf<Struct>> table,
                                     const Struct& defaults, const std::string& group) {
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

template <class Struct>
void SettingOptions<Struct>::apply(Struct& object) const {
    for (const SettingOf<Struct>& setting : table_) {
        const std::string option = "--" + setting.key;
        if (app_->count(option) == 0) continue;
        set_value(object, setting, value_from_text(values_.at(setting.key)), option);
    }
}

template class SettingOptions<Style>;
template class SettingOptions<FrameSettings>;

} // namespace lineatlas
