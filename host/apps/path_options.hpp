#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "command_line/cli_fwd.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas::apps {

/// --units, --page, --margin, --curves, --fit-arcs, --plotter, --no-tags and --certify.
class PathOptions {
  public:
    void declare(CLI::App& app);

    /// Throws UsageError if options are wrong, or given for a picture of pixels or for a method
    /// without paths. Throws FileError for an unknown type of paths, or if the module that checks
    /// drawings or writes PDF is not installed.
    void check(const std::filesystem::path& output, Method method) const;

    /// As check(), for a sheet of any type.
    void check_sheet(const std::filesystem::path& output, Method method) const;

    bool plotter() const { return plotter_; }
    bool tags() const { return !no_tags_; }
    bool certify() const { return certify_; }
    SvgOptions svg() const; ///< for DXF and PDF too
    /// The style of a picture of this size. With a page, its lengths are lengths on paper.
    Style on_paper(const Style& style, glm::ivec2 size) const;

  private:
    void refuse(std::span<const char* const> options, const std::string& why) const;

    CLI::App* app_ = nullptr;
    std::string units_, page_, margin_ = "0", curves_ = "auto";
    bool fit_arcs_ = false, plotter_ = false, no_tags_ = false, certify_ = false;
};

} // namespace lineatlas::apps
