#include "style_options.hpp"

#include <CLI/App.hpp>

#include "lineatlas/style_files.hpp"
#include "style/settings.hpp"

namespace lineatlas {

void StyleOptions::declare(CLI::App& app) {
    const std::string group = "Style";
    app.add_option("--style", name_,
                   "Name of a style, see `lineatlas styles`, or a TOML file; default plain, "
                   "with --views technical")
        ->group(group);
    app.add_option("--set", changes_, "key=value: change a setting of the style; may be repeated")
        ->allow_extra_args(false)
        ->group(group);
    settings_.declare(app, settings(), default_style(), group);
}

Style StyleOptions::style() const {
    Style style = !name_.empty() ? load_style(name_) : usual_ ? *usual_ : default_style();
    for (const std::string& change : changes_) apply_setting(style, change);
    settings_.apply(style);
    return style;
}

} // namespace lineatlas
