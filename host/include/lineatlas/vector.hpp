#pragma once

#include <cstdint>
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
#include "lineatlas/mesh.hpp"
#include "lineatlas/style.hpp"
#include "segment_table.h"

namespace lineatlas {

/// A point of a drawing.
struct VectorPoint {
    glm::dvec2 at{0, 0};       ///< pixels, from the upper left corner of the picture, y down
    double depth = 0;          ///< window depth, 0 near to 1 far
    double inverse_w = 1;      ///< 1/w of clip space: linear along a line on the screen
    glm::dvec3 world{0, 0, 0}; ///< the point of the model that is seen there
    double arc = 0;            ///< pixels along the line, 0 in its middle
};

/// Where a piece of a path comes from.
struct VectorPiece {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< no group
    std::uint32_t point = 0;   ///< it lies between this point of the path and the next one:
    float from = 0;            ///< share of the way between them at which it starts, 0 to 1
    float to = 1;              ///< and at which it ends
    std::uint32_t segment = 0; ///< index into LineSet::segments
    LineSource source{};       ///< in the mesh, in the direction of the path
    /// Of a smooth silhouette, a ridge or a valley, which runs through `source.triangle` and has no
    /// edge: over which place of it the piece starts, as shares of its three corners. Else 0.
    glm::vec3 over_start{0};
    glm::vec3 over_end{0};      ///< the same of its end
    std::uint32_t group = none; ///< index into VectorDrawing::groups
    /// Of a line along an edge of the file: its KnownEdge::edge.
    std::uint32_t edge = none;
    /// Of a silhouette on a known surface: index into KnownSurfaces::surfaces.
    std::uint32_t face = none;
    /// What the file calls that edge or face, as #12 of STEP; 0: nothing known.
    std::uint32_t entity = 0;
};

/// A part of a circle or an ellipse on the screen, all around at most: center + cos(t) major +
/// sin(t) minor, where the minor half axis is the major one, turned a quarter from x towards y, and
/// `ratio` times as long.
struct VectorArc {
    glm::dvec2 center{0, 0}; ///< in the middle
    glm::dvec2 major{1, 0};  ///< the longer half axis; of a circle along x
    double ratio = 1;        ///< above 0; 1: a circle
    double from = 0;         ///< t where it starts, radians
    double sweep = 0;        ///< from there on; negative: towards smaller t

    /// The point at an angle t.
    LINEATLAS_API glm::dvec2 at(double angle) const;
};

/// A cubic Bézier curve between two points.
struct VectorCubic {
    glm::dvec2 first_control{0, 0}; ///< towards it the curve leaves the first point
    glm::dvec2 last_control{0, 0};  ///< from it the curve comes to the last
};

/// A part of a path that is round.
struct VectorCurve {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< no edge
    std::uint32_t first = 0;                          ///< it begins at this point of the path,
    std::uint32_t last = 0; ///< and ends at this one; those between are on it
    VectorArc arc{};        ///< that of the file (Mesh::edge_curves), as seen; pixels
    /// In place of the arc, of what is none: through the points, within a tenth of a pixel of
    /// every chord's curve.
    std::optional<VectorCubic> cubic{};
    std::uint32_t edge = none; ///< the first KnownEdge::edge along it
};

/// A polyline that is drawn in one go.
struct VectorPath {
    LineKind kind = LineKind::crease; ///< all along
    bool visible = true;              ///< else it is hidden, all along
    bool closed = false;              ///< the last point is where the first one is
    bool outline = false;             ///< beside the background all along
    /// Left out where lines are dense (Style::density): files have it where it is not shown.
    bool thinned = false;
    std::uint32_t pen = 0;           ///< index into VectorDrawing::pens, or hidden_pens
    float alpha = 1;                 ///< mean visibility
    std::vector<VectorPoint> points; ///< two at least
    /// In order; several of one point where segments in a row lie on one straight line.
    std::vector<VectorPiece> pieces;
    /// In order along the path, none over another. Of a loop none goes over its first point, unless
    /// it is all of it.
    std::vector<VectorCurve> curves{};
};

/// What a plotter's pen travels without drawing, in pixels, and how many paths it draws.
struct PenTravel {
    double before = 0;            ///< of paths in the order of a picture
    double after = 0;             ///< of the plotter's
    std::size_t paths_before = 0; ///< and how many paths there were
    std::size_t paths_after = 0;  ///< and are
};

/// A drawing as paths, in the order in which they are drawn: hidden lines before visible ones, and
/// within both by kind.
struct VectorDrawing {
    glm::ivec2 size{1, 1};        ///< of the picture in pixels
    Style style{};                ///< colour of the paper
    std::vector<Pen> pens{Pen{}}; ///< of visible paths; the first is the style's own
    /// Of hidden paths, likewise.
    std::vector<Pen> hidden_pens{Style{}.hidden_pen};
    std::vector<MeshGroup> groups;     ///< what pieces belong to; empty where none are known
    std::vector<VectorPath> paths;     ///< in the order in which they are drawn
    std::optional<PenTravel> travel{}; ///< of a drawing for a plotter, which has no thinned paths
    double thinned_share = 0;          ///< of the length of all lines: VectorPath::thinned
};

/// How intervals become paths.
struct VectorOptions {
    /// The mesh that the lines were extracted from: pieces then know their object and material, and
    /// paths their curves.
    const Mesh* mesh = nullptr;
    /// What LineVisibility::outlines() or Renderer::read_outlines() found with the intervals; only
    /// a style with pens for outlines needs them.
    std::span<const OutlinePart> outlines{};
    double tolerance = 0.05; ///< pixels by which simplified paths may be off, at least 0
    bool plotter = false;    ///< order, turn and join paths for the least travel of the pen
};

/// The drawing of what `Renderer::read_intervals` gave for a frame with this camera. Hidden lines
/// are in it if the style draws them and `intervals` has them. Throws UsageError for a line set, a
/// camera and a style that a renderer does not take.
LINEATLAS_API VectorDrawing make_vector_drawing(const LineSet& lines, const Camera& camera,
                                                std::span<const Interval> intervals,
                                                const Style& style,
                                                const VectorOptions& options = {});

/// Units of length on paper.
enum class Unit {
    px, ///< pixels of CSS: 96 to an inch
    mm, ///< millimetres
    in, ///< inches
};

/// A length on paper.
struct Length {
    double value = 0;     ///< how many
    Unit unit = Unit::px; ///< of these
};

/// The length in another unit.
LINEATLAS_API double length_in(Length length, Unit unit);

/// Throws UsageError unless it is "px", "mm" or "in".
LINEATLAS_API Unit parse_unit(std::string_view text);

/// "10mm", "0.5in", "12px", or a number of `unit`. Throws UsageError, also for less than 0.
LINEATLAS_API Length parse_length(std::string_view text, Unit unit);

/// A sheet of paper.
struct Page {
    Length width;       ///< from left to right
    Length height;      ///< from top to bottom
    bool turns = false; ///< may lie on its side, as the drawing does
};

/// "a0" to "a6", "letter", "legal", "tabloid", or width and height as "300x200mm". Throws
/// UsageError that names them.
LINEATLAS_API Page parse_page(std::string_view text);

/// A style for a picture of so many pixels that is scaled to fit on a page: lengths of a style that
/// grow with its picture (Style::made_for) are those of paper, 96 pixels to an inch, whatever the
/// size of the page. Other styles stay as they are. Throws UsageError when the margin leaves no
/// room.
LINEATLAS_API Style style_on_page(const Style& style, glm::ivec2 picture, const Page& page,
                                  Length margin = {});

/// How a drawing is written as SVG.
struct SvgOptions {
    Unit units = Unit::px; ///< of the page's width and height in the file
    /// The picture is scaled to fit on it and centred. None: the page is the picture.
    std::optional<Page> page{};
    Length margin{};        ///< around the picture, on all four sides
    bool background = true; ///< the paper's colour, unless it is white
    bool tags = true;       ///< where each path comes from; never in a drawing for a plotter
    bool layers = true;     ///< mark groups as layers of Inkscape
    bool relative = true;   ///< shorter path data
    bool curves = true;     ///< VectorPath::curves leave as arcs, else as chords
    bool fit_arcs = false;  ///< where there are none they are looked for (docs/vector.md)
    std::string title = "Line drawing"; ///< of the document
    std::string description{};          ///< the settings that made it, for people
    std::string certificate{};          ///< what a check of it found, as metadata; empty: none
};

/// The drawing as SVG 1.1. Throws UsageError when the margin leaves no room, and for a pen or a
/// paper of the drawing that no style can have.
LINEATLAS_API std::string to_svg(const VectorDrawing& drawing, const SvgOptions& options = {});

/// How a drawing is written as DXF.
struct DxfOptions {
    /// The picture is scaled to fit on it and centred. None: the page is the picture.
    std::optional<Page> page{};
    Length margin{};           ///< around the picture, on all four sides
    bool curves = true;        ///< as in SvgOptions
    bool fit_arcs = false;     ///< as in SvgOptions
    std::string description{}; ///< the settings that made it, as a comment
    std::string certificate{}; ///< what a check of it found, as a comment; empty: none
};

/// The drawing as DXF of AutoCAD 2004, ASCII, in millimetres of the page from its lower left
/// corner. Throws UsageError as to_svg() does.
LINEATLAS_API std::string to_dxf(const VectorDrawing& drawing, const DxfOptions& options = {});

/// How a drawing is written as JSON.
struct JsonOptions {
    bool tags = true;          ///< the pieces of each path
    std::string description{}; ///< the settings that made it, for people
    std::string certificate{}; ///< what a check of it found; empty: none
    glm::dvec3 origin{0};      ///< added to points in space: LoadedMesh::origin
};

/// The drawing as JSON (docs/vector.md). Throws UsageError as to_svg() does.
LINEATLAS_API std::string to_json(const VectorDrawing& drawing, const JsonOptions& options = {});

} // namespace lineatlas
