#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "command_line/cli_fwd.hpp"
#include "command_line/view_options.hpp"
#include "lineatlas/sheet.hpp"

namespace lineatlas::apps {

/// The arguments of `draw --views` that other pictures do not have: --field and --detail, and
/// --views,
/// --projection, --scale and --page for a sheet.
class SheetArguments {
  public:
    /// `app` must outlive this object, and this object the parsing.
    void declare(CLI::App& app);

    /// Throws UsageError if --field is given without a sheet, and for options that are wrong or of
    /// no use for a sheet. Throws FileError for a type that holds no sheet.
    void check(const ViewOptions& view, const std::filesystem::path& output) const;

    /// The options of a model's sheet. `page`: nothing: as the sheet's file has it, else a3.
    /// `origin`: of the mesh, in the file's coordinates.
    SheetOptions options(const ViewOptions& view, const std::optional<Page>& page,
                         const std::filesystem::path& model, std::optional<double> unit_of_file,
                         glm::vec3 up, glm::dvec3 origin) const;

    /// Whether a view of --views is a section.
    static bool has_sections(const ViewOptions& view);

    /// Whether --views is a TOML file that describes the sheet.
    static bool is_file(const ViewOptions& view) { return view.views().ends_with(".toml"); }

    /// Whether --views is auto: the views that show a part, its measures, and a summary.
    static bool wants_summary(const ViewOptions& view) { return view.views() == "auto"; }

  private:
    CLI::App* app_ = nullptr;
    std::vector<std::string> fields_, details_;
};

} // namespace lineatlas::apps
