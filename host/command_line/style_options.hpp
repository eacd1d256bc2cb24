#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli_fwd.hpp"
#include "lineatlas/style.hpp"
#include "setting_options.hpp"

namespace lineatlas {

/// --style, --set and an option for every setting (host/style/settings.hpp).
class StyleOptions {
  public:
    /// `app` must outlive this object, and this object the parsing.
    void declare(CLI::App& app);

    /// The style's file, then --set, then options of their own. Throws Error.
    Style style() const;
    /// Sets the style without --style, in place of default_style().
    void set_usual(const Style& style) { usual_ = style; }
    /// The value of --style: a style's name or a file; empty: none.
    const std::string& name() const { return name_; }

  private:
    std::string name_;
    std::optional<Style> usual_;
    std::vector<std::string> changes_;
    SettingOptions<Style> settings_;
};

} // namespace lineatlas
