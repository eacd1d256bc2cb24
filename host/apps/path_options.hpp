#pragma once

#include <filesystem>
#include <string>

#include <CLI/App.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas::apps {

/// Whether a drawing is written as paths: .svg or .json.
bool is_path_file(const std::filesystem::path& path);
bool is_json_file(const std::filesystem::path& path);

/// --units, --page, --margin, --plotter and --no-tags.
class PathOptions {
  public:
    void declare(CLI::App& app);

    /// Throws UsageError when they are wrong, or given for a picture of pixels.
    void check(const std::filesystem::path& output) const;

    bool plotter() const { return plotter_; }
    bool tags() const { return !no_tags_; }
    SvgOptions svg() const;

  private:
    CLI::App* app_ = nullptr;
    std::string units_, page_, margin_ = "0";
    bool plotter_ = false, no_tags_ = false;
};

} // namespace lineatlas::apps
