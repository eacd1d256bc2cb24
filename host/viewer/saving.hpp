#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "io/image_writer.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/sheet.hpp"
#include "loader.hpp"

namespace lineatlas::viewer {

/// A picture to be saved. `lineatlas draw` draws the same of this model, camera and options.
struct SavedPicture {
    const Model& model;
    View view;
    glm::ivec2 size;
    FrameOptions options;
    /// The page that paths fill, as --page and --margin say.
    struct Paper {
        std::string page{};
        float margin = 0; ///< millimetres
    };
    std::optional<Paper> paper{};
    bool plotter = false;  ///< paths in the order of a pen, without a paper of their own
    bool fit_arcs = false; ///< of paths
    float dpi = 0;         ///< resolution of pixels; 0: not given
    /// Asked between steps of the work, the last time before the file is written. After false
    /// save() throws Cancelled, and nothing is written.
    std::function<bool()> goes_on{};
};

/// Throws Cancelled if `goes_on` says no.
void go_on(const std::function<bool()>& goes_on);

/// Saves pixels or paths, by extension. Throws Error.
void save(const SavedPicture& picture, const std::filesystem::path& path, Renderer& renderer,
          ImageWriter& writer);

/// Options with which a renderer finds paths as the tool does, whatever is on the screen.
FrameOptions options_of_paths(FrameOptions options);

/// The paths that the renderer finds with such options, and if `filled` the fills of the style.
SeenLines find_paths(Renderer& renderer, const LineSet& lines, const Camera& camera,
                     const FrameOptions& options, bool filled);

/// The arguments with which `lineatlas` draws the picture, except those of the camera.
std::string command_of(const SavedPicture& picture);

/// Writes a text file. Throws FileError.
void save_text(const std::string& text, const std::filesystem::path& path);

/// `folder`/`stem`.`extension`, or, if that is taken, the first that is free of
/// `stem`-2.`extension` and so on.
std::filesystem::path free_path(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension,
                                const std::function<bool(const std::filesystem::path&)>& is_taken);

} // namespace lineatlas::viewer
