#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/image_writer.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/sheet.hpp"
#include "loader.hpp"

namespace lineatlas::viewer {

/// The type of file that a drawing is written to.
enum class FileFormat { png, svg, pdf, dxf, json };
inline constexpr std::array<const char*, 5> format_extensions{"png", "svg", "pdf", "dxf", "json"};

/// What a drawing is for.
enum class Purpose { screen, print, plotter, laser };

/// How a drawing leaves the viewer.
struct ExportOptions {
    Purpose purpose = Purpose::screen;
    FileFormat format = FileFormat::png;
    bool purpose_by_format = false; ///< it is in place of the screen, see as_format()
    bool sheet = false;             ///< several aligned views in place of the current one
    std::vector<std::string> views = SheetOptions{}.views; ///< of a sheet
    bool measures = false;                                 ///< likewise
    /// Pixels of a picture for the screen per pixel of the window and axis.
    int pixels = 1;
    std::string page = "a4"; ///< name for parse_page()
    std::string scale{};     ///< as in "1:2"; empty: as large as the page allows
    float margin = 10;       ///< millimetres

    bool operator==(const ExportOptions&) const = default;
};

/// The options with the usual format for a purpose, and the settings that go with it.
ExportOptions suited_to(Purpose purpose, ExportOptions options);

/// The options with a format. PDF and DXF have a page and a scale, and the purpose `screen` has
/// none: PDF changes it to `print`, DXF to `laser`. Another format, with one view, changes it back.
ExportOptions as_format(FileFormat format, ExportOptions options);

/// A typed scale as ExportOptions::scale: a factor such as 0.4 becomes "1:2.5", and other text
/// stays as it is.
std::string scale_of_text(std::string text);

/// Whether the drawing has a page. A picture for the screen and JSON have none.
bool is_on_paper(const ExportOptions& options);

/// The drawing to be written.
struct ExportedDrawing {
    std::shared_ptr<const Model> model;
    View view;         ///< the current view
    glm::ivec2 window; ///< pixels of the view in the window
    FrameOptions options;
    std::function<bool()> goes_on{}; ///< SavedPicture::goes_on
};

/// A view on a page.
struct PageView {
    Camera camera;      ///< draws it
    Style style;        ///< in pixels of the camera
    glm::dvec2 low{0};  ///< upper left corner of the camera's picture on the page
    glm::dvec2 high{0}; ///< its lower right corner
};

/// A page with its views. Lengths are millimetres, or pixels without paper, from the upper left
/// corner.
struct ExportPage {
    glm::dvec2 size{0};
    std::string scale{};           ///< of all views; empty: none
    std::vector<PageView> views{}; ///< one, or those of the sheet
    std::optional<SheetLayout> sheet{};
};

/// Lays out the page. Throws UsageError for impossible options, such as a scale that does not fit.
ExportPage lay_out(const ExportOptions& options, const ExportedDrawing& drawing);

/// Writes the file. Throws Error.
void save(const ExportOptions& options, const ExportedDrawing& drawing,
          const std::filesystem::path& path, Renderer& renderer, ImageWriter& writer);

} // namespace lineatlas::viewer
