#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/export.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/style.hpp"
#include "lineatlas/vector.hpp"

/// @file
/// Sheets: several views of one model on one page, as workshops expect them. lay_out_sheet() places
/// the views and chooses their cameras, make_vector_sheet() draws the views, and to_svg() and
/// to_dxf() write the sheet.
/// @code{.cpp}
/// LineVisibility visibility{lines};
/// const SheetLayout layout = lay_out_sheet(lines.vertices, {.views = {"front", "top"}});
/// const VectorSheet sheet = make_vector_sheet(
///     lines, layout,
///     [&](const SheetView& shown) {
///         return SeenLines{visibility.find(shown.camera, {.hidden = true})};
///     },
///     load_style("technical"));
/// std::ofstream{"sheet.svg"} << to_svg(sheet);
/// @endcode

namespace lineatlas {

/// On which side of the front view the others stand (ISO 5456-2).
enum class ProjectionAngle {
    first, ///< the view from above stands below the front
    third, ///< the view from above stands above the front
};

/// "first" or "third".
LINEATLAS_API std::string_view name_of(ProjectionAngle angle);

/// The angle of that name; throws UsageError that lists both names.
LINEATLAS_API ProjectionAngle parse_projection_angle(std::string_view name);

/// The fields of a title block (ISO 7200), UTF-8. An empty field stays empty, to be filled by hand.
struct SheetFields {
    std::string title{};    ///< of the drawing
    std::string file{};     ///< name of the model's file
    std::string owner{};    ///< legal owner of the drawing
    std::string number{};   ///< the owner's number of the drawing
    std::string creator{};  ///< who drew it
    std::string approver{}; ///< who approved it
    std::string date{};     ///< of issue
};

/// Sets the field of that name, such as "title". Throws UsageError that lists all names.
LINEATLAS_API void set_field(SheetFields& fields, std::string_view name, std::string value);

/// A part of a view that is drawn once more, larger: a detail.
struct SheetDetail {
    std::string view;     ///< the view that shows it, as in SheetOptions::views
    glm::dvec3 center{0}; ///< of the circle around it, in the coordinates of sections' planes
    double radius = 0;    ///< of the circle, units of the model, above 0
    /// Its own, as in "5:1", larger than that of the sheet; empty: the smallest of ISO 5455 that is
    /// at least twice that of the sheet.
    std::string scale{};
    /// Millimetres from the page's upper left corner, y down: the middle of the detail; nothing:
    /// where there is room.
    std::optional<glm::dvec2> at{};
};

/// A view that is placed by hand, or has a scale of its own.
struct SheetPlacement {
    std::string view; ///< as in SheetOptions::views
    /// Millimetres from the page's upper left corner, y down: the middle of the box around the
    /// view; nothing: where the angle of projection puts it.
    std::optional<glm::dvec2> at{};
    std::string scale{}; ///< its own, as in "1:2"; empty: that of the sheet
};

/// "front/20,35,0/8" as the detail of the view "front" about that point with a radius of 8;
/// "front/20,35,0/8/5:1" at that scale. Throws UsageError for any other text.
LINEATLAS_API SheetDetail parse_detail(std::string_view text);

/// The contents and the layout of a sheet.
struct SheetOptions {
    /// Sides to look from, as view_direction() takes them, each once, 64 at most. The six named
    /// sides are aligned with the front; any other side is a pictorial view, which shows no hidden
    /// lines and is placed where there is room. "section:x=12" is a section: the model cut by a
    /// plane, as parse_section() takes it, seen from the side that is cut away. A plane without a
    /// sign cuts away the side from which the front, the right or the top looks. The section stands
    /// where the view from that side would stand, or to the right of that view if the sheet has
    /// it. A section that no named side looks at, as "section:0,0,0/1,1,0", is placed where there
    /// is room, turned about the line of its plane. That line is drawn on the first aligned view
    /// that shows the plane as a line, or else on the first pictorial one.
    std::vector<std::string> views{"front", "top", "right", "isometric"};
    /// Views that stand elsewhere than the angle of projection says, or have another scale; each
    /// view at most once.
    std::vector<SheetPlacement> placements{};
    /// Details, each placed where there is room. Letters go on after those of sections.
    std::vector<SheetDetail> details{};
    ProjectionAngle angle = ProjectionAngle::third; ///< of the aligned views
    /// The page, by default A3. A page with `turns` stands upright if it is at most as wide as A4,
    /// otherwise it lies on its side (ISO 5457).
    Page page{.width = {297, Unit::mm}, .height = {420, Unit::mm}, .turns = true};
    /// One for all views, as in "1:2"; empty: the largest of ISO 5455 that fits.
    std::string scale{};
    double unit = 1;       ///< millimetres in a unit of the model, above 0
    glm::vec3 up{0, 1, 0}; ///< the upward axis of the model, a unit axis
    /// Origin of the points in the coordinates of sections' planes: LoadedMesh::origin.
    glm::dvec3 origin{0};
    SheetFields fields{}; ///< of the title block
    /// Overall sizes as dimensions in millimetres, the model's axes beside each view, and a scale
    /// bar.
    bool measures = false;
};

/// "front,30,20,section:x=12" as "front", "30,20" and "section:x=12". Throws UsageError for a side
/// that view_direction() does not know, for a plane that parse_section() does not know, for a view
/// that is named twice, and for none.
LINEATLAS_API std::vector<std::string> parse_views(std::string_view text);

/// The sheet that a TOML file describes (docs/sheets.md): page, angle, scale, views, details and
/// fields; the rest stays as in SheetOptions{}. Throws FileError that names the file, the line and
/// the key.
LINEATLAS_API SheetOptions load_sheet(const std::filesystem::path& file);

/// A view and its place on the sheet.
struct SheetView {
    std::string name;     ///< as in SheetOptions::views; of a detail with its letter, "detail_B"
    std::string letter{}; ///< of a section or a detail, as "A"
    std::string
        own_scale{};        ///< of a detail, and of a view whose scale is not the sheet's, as "5:1"
    bool pictorial = false; ///< not aligned with others; without hidden lines
    bool detail = false;    ///< nothing is drawn outside of the circle in its box
    /// Of a section, and a detail of one: the plane that cuts the model, in the coordinates of its
    /// points. The view shows what cut_mesh() leaves, without hidden lines.
    std::optional<SectionPlane> cut{};
    Camera camera{};      ///< draws the view; orthographic
    double scale = 1;     ///< millimetres of paper in a pixel of the camera's picture
    glm::dvec2 corner{0}; ///< millimetres: upper left corner of that picture
    glm::dvec2 low{0};    ///< millimetres: upper left corner of the box around the drawing
    glm::dvec2 high{0};   ///< millimetres: lower right corner of that box
};

/// A line of the sheet itself, straight from point to point.
struct SheetLine {
    /// "frame", "title-block", "sections", "details", "dimensions", "axes" or "scale-bar".
    std::string layer;
    double width = 0.25;            ///< millimetres
    std::vector<glm::dvec2> points; ///< millimetres; two at least
};

/// A circle of the sheet itself.
struct SheetCircle {
    std::string layer;    ///< as of lines
    double width = 0.25;  ///< millimetres
    glm::dvec2 center{0}; ///< millimetres
    double radius = 1;    ///< millimetres
};

/// Which part of a text is at its point.
enum class TextAnchor {
    start,  ///< its start
    middle, ///< its middle
    end,    ///< its end
};

/// A text of the sheet itself, on one line.
struct SheetText {
    std::string layer;                     ///< as of lines
    glm::dvec2 at{0};                      ///< millimetres, a point on the baseline
    double height = 2.5;                   ///< of capital letters, millimetres
    std::string text;                      ///< UTF-8
    TextAnchor anchor = TextAnchor::start; ///< which part of it is at the point
    bool upward = false;                   ///< read from below to above, else from left to right
};

/// A page with places for views, its frame and its title block. Millimetres from the upper left
/// corner, y down.
struct SheetLayout {
    glm::dvec2 size{0};                 ///< of the page
    std::string scale{};                ///< of the views that have none of their own, as in "1:2"
    std::string title{};                ///< of the document
    bool measures = false;              ///< as in SheetOptions
    std::vector<SheetView> views{};     ///< in the order in which they were asked for, then details
    std::vector<SheetLine> lines{};     ///< of the sheet's own
    std::vector<SheetCircle> circles{}; ///< of details and of the symbol in the title block
    std::vector<SheetText> texts{};     ///< of frame and title block
};

/// Lays out a sheet for a model with these points, such as LineSet::vertices. Throws UsageError if
/// there are no points, for options out of range, for a section that misses the model or whose
/// plane no other view shows as a line, for a detail beside its view or no larger than it, for a
/// view placed by hand that leaves the frame or meets another view or the title block, for more
/// sections and details than letters (A to Z without I and O),
/// for a page without room for the views, and for a scale that does not fit; the message then names
/// one that fits.
LINEATLAS_API SheetLayout lay_out_sheet(std::span<const glm::vec3> points,
                                        const SheetOptions& options = {});

/// The parts of lines that a camera sees.
struct SeenLines {
    std::vector<Interval> intervals; ///< hidden ones, too
    /// Outlines of the same lines, as LineVisibility::outlines() returns them; only a style with
    /// pens for outlines needs them.
    std::vector<OutlinePart> outlines{};
    std::vector<VectorFill> fills{}; ///< of a style that fills: find_fills() finds them
    /// For a section, the lines of the model after the cut. The function that found them owns them,
    /// and keeps them until it is called for the next view.
    const LineSet* lines = nullptr;
    const Mesh* mesh = nullptr; ///< for a section, the model after the cut; lives as `lines` do
};

/// Finds what `camera` sees of lines. Hidden intervals are needed too, because a style may close
/// gaps in a line. LineVisibility::find() and Renderer::read_intervals() return such intervals.
using FindLines = std::function<SeenLines(const Camera& camera)>;

/// Finds what the camera of a view sees of the model, or of the rest of it if the view is a
/// section. Hidden intervals are needed too.
using FindViewLines = std::function<SeenLines(const SheetView& view)>;

/// A sheet with its views drawn.
struct VectorSheet {
    SheetLayout layout; ///< where they stand; with the lines and texts of measures, if it has them
    std::vector<VectorDrawing> drawings; ///< one for each of SheetLayout::views
    /// Of a layout with measures: the model's overall sizes along its axes in millimetres, as the
    /// aligned views show them. Sizes of round bodies are true ones, not those of chords. 0 along
    /// an axis that no aligned view shows.
    glm::dvec3 model_size{0};
};

/// Draws every view of a layout. A pixel of the style is that of CSS, 1/96 inch, whatever the
/// paper's size: Style::made_for says nothing here. Throws as make_vector_drawing() and `find` do,
/// and UsageError if `find` has no lines for a section.
LINEATLAS_API VectorSheet make_vector_sheet(const LineSet& lines, const SheetLayout& layout,
                                            const FindViewLines& find, const Style& style,
                                            const VectorOptions& options = {});

/// The style as it draws one view, in pixels of the view's camera.
LINEATLAS_API Style style_of_view(const Style& style, const SheetView& view);

/// How a sheet is written.
struct SheetWriting {
    bool background = true;    ///< the paper's colour, unless it is white; SVG
    bool tags = true;          ///< where each path comes from; SVG
    bool layers = true;        ///< mark groups as layers of Inkscape; SVG
    bool curves = true;        ///< as in SvgOptions
    bool fit_arcs = false;     ///< as in SvgOptions
    std::string description{}; ///< the settings that made it, for people
};

/// The sheet as SVG 1.1 in millimetres: a group for each view, named after it, with groups as
/// to_svg() of a drawing has them, and one for each layer of the sheet's own. Throws UsageError as
/// that does, and where a layout has another number of views than there are drawings.
LINEATLAS_API std::string to_svg(const VectorSheet& sheet, const SheetWriting& writing = {});

/// The sheet as DXF of AutoCAD 2004 in millimetres from its lower left corner: layers as to_dxf()
/// of a drawing has them, the view's name before each, and those of the sheet's own. Throws as
/// to_svg() does.
LINEATLAS_API std::string to_dxf(const VectorSheet& sheet, const SheetWriting& writing = {});

} // namespace lineatlas
