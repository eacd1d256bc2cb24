#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// A drawing as a TOML file: what `lineatlas view` saves and opens, and `lineatlas draw` draws
/// (docs/viewer.md).
struct SessionFile {
    /// An option of `lineatlas draw` without its "--", with its values.
    struct Option {
        std::string key;
        std::vector<std::string> values;
    };
    struct NamedView {
        std::string name{};
        glm::dvec3 eye{0}, target{0}; ///< in the model file's coordinates
        glm::vec3 up{0, 1, 0};
        float fov = 40; ///< degrees
        Projection projection = Projection::perspective;

        bool operator==(const NamedView&) const = default;
    };

    std::vector<std::filesystem::path> models{}; ///< side by side, see join_models(); none: `scene`
    std::string scene{};
    std::vector<Option> options{};
    std::vector<std::string> sections_off{}; ///< in the form of --section; these do not cut
    std::vector<NamedView> views{};          ///< the first is seen; others are kept for later
    std::string style_name{};                ///< name or path that the style was taken from
    Style style{};
};

/// Whether a file says that it is a session. Throws FileError if it is no TOML.
bool is_session(const std::filesystem::path& file);

/// Reads a session. Throws FileError that names file, line and key.
SessionFile read_session(const std::filesystem::path& file);

/// The text of a session's file in `folder`. Models below the folder have relative paths.
std::string write_session(const SessionFile& session, const std::filesystem::path& folder);

/// These convert a camera between the coordinates of a file and those about its origin.
SessionFile::NamedView named_view(const View& view, glm::dvec3 origin, std::string name = {});
View view_of(const SessionFile::NamedView& view, glm::dvec3 origin);

/// The shortest text that reads as the same number; of a float, the shortest for that float.
std::string shortest(double value);

} // namespace lineatlas
