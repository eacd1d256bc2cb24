#pragma once

#include <map>
#include <span>
#include <string>

#include "cli_fwd.hpp"
#include "style/setting.hpp"

namespace lineatlas {

/// An option for every setting of a table: of styles or of frames.
template <class Struct>
class SettingOptions {
  public:
    /// `app` must outlive this object, and this object the parsing. `defaults`: the values without
    /// options, for --help.
    void declare(CLI::App& app, std::span<const SettingOf<Struct>> table, const Struct& defaults,
                 const std::string& group);

    /// Sets what was given. Throws UsageError that names the option.
    void apply(Struct& object) const;

  private:
    const CLI::App* app_ = nullptr;
    std::span<const SettingOf<Struct>> table_;
    std::map<std::string, std::string> values_; ///< by key, as written
};

} // namespace lineatlas
