#include "style_options.hpp"

#include "lineatlas/style_files.hpp"
#include "style/settings.hpp"

namespace lineatlas::apps {

void StyleOptions::declare(CLI::App& app) {
    app_ = &app;
    const std::string group = "Style";
    app.add_option("--style", name_,
                   "Name of a style, see `lineatlas styles`, or a TOML file; default plain lines")
        ->group(group);
    app.add_option("--set", changes_, "key=value: change a setting of the style; may be repeated")
        ->allow_extra_args(false)
        ->group(group);
    const Style defaults;
    for (const Setting& setting : settings()) {
        std::string& value = values_[setting.key];
        const std::string option = "--" + setting.key;
        const std::string help = setting.help + ": " + setting.values;
        if (setting.flag) {
            app.add_flag(option, value, help)->group(group);
        } else {
            app.add_option(option, value, help)
                ->default_str(value_to_toml(setting.get(defaults)))
                ->group(group);
        }
    }
}

Style StyleOptions::style() const {
    Style style;
    if (!name_.empty()) style = load_style(name_);
    for (const std::string& change : changes_) apply_setting(style, change);
    for (const Setting& setting : settings()) {
        const std::string option = "--" + setting.key;
        if (app_->count(option) == 0) continue;
        set_value(style, setting, value_from_text(values_.at(setting.key)), option);
    }
    return style;
}

} // namespace lineatlas::apps
