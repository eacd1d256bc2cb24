#pragma once

#include <string>
#include <utility>
#include <vector>

#include "command_line/cli_fwd.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/section.hpp"

namespace lineatlas::apps {

/// --section, --hatching and --uncut.
class SectionOptions {
  public:
    SectionOptions() = default;
    /// The values in a drawing's description; empty: not given.
    SectionOptions(std::vector<std::string> planes, std::string hatching,
                   std::vector<std::string> uncut)
        : planes_(std::move(planes)), hatching_(std::move(hatching)), uncut_(std::move(uncut)) {}
    void declare(CLI::App& app, const std::string& group);

    /// Throws UsageError for values that are wrong for any model. `sheet_cuts`: a view of a sheet
    /// is a section, which --hatching and --uncut are for, too.
    void check(bool sheet_cuts) const;

    bool given() const { return !planes_.empty(); }
    Hatching hatching() const; ///< throws UsageError
    /// Names of parts that stay whole.
    const std::vector<std::string>& uncut() const { return uncut_; }
    /// Cuts the mesh. `origin`: that of mesh and view, in the file's coordinates. Planes without a
    /// side take away the side that the view's eye is on. Throws UsageError.
    Section cut(const Mesh& mesh, glm::dvec3 origin, const View& view) const;
    /// The planes as written, each with the side that cut() takes away.
    std::vector<std::string> with_sides(const Mesh& mesh, glm::dvec3 origin,
                                        const View& view) const;

  private:
    std::vector<SectionPlane> planes(const Mesh& mesh, glm::dvec3 origin, const View& view) const;

    CLI::App* app_ = nullptr;
    std::vector<std::string> planes_;
    std::string hatching_;
    std::vector<std::string> uncut_;
};

} // namespace lineatlas::apps
