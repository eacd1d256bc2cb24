#pragma once

#include <map>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "lineatlas/style.hpp"

namespace lineatlas::apps {

/// --style, --set and an option for every setting (host/style/settings.hpp).
class StyleOptions {
  public:
    /// Both live as long as each other.
    void declare(CLI::App& app);

    /// The style's file, then --set, then options of their own. Throws Error.
    Style style() const;

  private:
    const CLI::App* app_ = nullptr;
    std::string name_;
    std::vector<std::string> changes_;
    std::map<std::string, std::string> values_; ///< by key, as written
};

} // namespace lineatlas::apps
