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

/// @file
/// Drawings as paths, and how they become SVG, DXF and JSON.
/// @code{.cpp}
/// LineVisibility visibility{lines};
/// const VectorDrawing drawing = make_vector_drawing(
///     lines, camera, visibility.find(camera, {.hidden = true}), style, {.mesh = &mesh});
/// std::ofstream{"drawing.svg"} << to_svg(drawing, {.page = parse_page("a4")});
/// std::ofstream{"drawing.dxf"} << to_dxf(drawing, {.page = parse_page("a3")});
/// @endcode

namespace lineatlas {

/// A point of a drawing.
struct VectorPoint {
    glm::dvec2 at{0, 0};       ///< pixels, from the upper left corner of the picture, y down
    double depth = 0;          ///< window depth, 0 near to 1 far
    double inverse_w = 1;      ///< 1/w of clip space: linear along a line on the screen
    glm::dvec3 world{0, 0, 0}; ///< the point of the model there
    double arc = 0;            ///< pixels along the line, 0 in its middle
};

/// Where a piece of a path comes from.
struct VectorPiece {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< no group
    std::uint32_t point = 0;   ///< the piece lies between this point of the path and the next one
    float from = 0;            ///< share of the way between these points where it starts, 0 to 1
    float to = 1;              ///< the share where it ends
    std::uint32_t segment = 0; ///< index into LineSet::segments
    LineSource source{};       ///< in the mesh, in the direction of the path
    /// For a smooth silhouette, a ridge or a valley, which runs through `source.triangle` and has
    /// no edge: the place in the triangle where the piece starts, as shares of its three corners.
    /// Else 0.
    glm::vec3 over_start{0};
    glm::vec3 over_end{0};      ///< the same for the piece's end
    std::uint32_t group = none; ///< index into VectorDrawing::groups
    /// For a line along an edge of the file: its KnownEdge::edge.
    std::uint32_t edge = none;
    /// For a silhouette on a known surface: index into KnownSurfaces::surfaces.
    std::uint32_t face = none;
    /// The file's number for that edge or face, 12 for #12 of STEP; 0: not known.
    std::uint32_t entity = 0;
};

/// A part of a circle or an ellipse on the screen, at most once around: center + cos(t) major +
/// sin(t) minor. The minor half axis is the major one, turned a quarter from x towards y, and
/// `ratio` times as long.
struct VectorArc {
    glm::dvec2 center{0, 0}; ///< the centre
    glm::dvec2 major{1, 0};  ///< the longer half axis; for a circle along x
    double ratio = 1;        ///< above 0; 1: a circle
    double from = 0;         ///< t where it starts, radians
    double sweep = 0;        ///< radians from there to the end; negative: towards smaller t

    /// The point at an angle t.
    LINEATLAS_API glm::dvec2 at(double angle) const;
};

/// A cubic Bézier curve between two points.
struct VectorCubic {
    glm::dvec2 first_control{0, 0}; ///< the curve leaves the first point towards this one
    glm::dvec2 last_control{0, 0};  ///< the curve reaches the last point from this one
};

/// A part of a path that is round.
struct VectorCurve {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< no edge
    std::uint32_t first = 0;                          ///< point of the path where it begins
    std::uint32_t last = 0; ///< point of the path where it ends; those between lie on it
    /// The file's curve (Mesh::edge_curves), or the circle that a mesh was cut from, on the screen;
    /// pixels.
    VectorArc arc{};
    /// Set if the curve is no arc, and used in place of it: a cubic through the points, within a
    /// tenth of a pixel of every chord's curve.
    std::optional<VectorCubic> cubic{};
    std::uint32_t edge = none; ///< the first KnownEdge::edge along it
};

/// A polyline that is drawn in one go.
struct VectorPath {
    LineKind kind = LineKind::crease; ///< kind of the whole path
    bool visible = true;              ///< visible all along; else hidden all along
    bool closed = false;              ///< the last point is where the first one is
    bool outline = false;             ///< has background beside it all along; never of a hole
    /// Left out where lines are dense (Style::density): files have the path on a layer that is not
    /// shown.
    bool thinned = false;
    std::uint32_t pen = 0;           ///< index into VectorDrawing::pens, or hidden_pens
    float alpha = 1;                 ///< mean visibility
    std::vector<VectorPoint> points; ///< two at least
    /// In order along the path. Several pieces have the same point if consecutive segments lie on
    /// one straight line.
    std::vector<VectorPiece> pieces;
    /// In order along the path, without overlaps. In a loop no curve passes over the first point,
    /// unless it is the whole loop.
    std::vector<VectorCurve> curves{};
};

/// The distance that a plotter's pen travels without drawing, in pixels, and the number of paths it
/// draws.
struct PenTravel {
    double before = 0;            ///< distance in the order of a picture
    double after = 0;             ///< distance in the plotter's order
    std::size_t paths_before = 0; ///< number of paths before they were joined
    std::size_t paths_after = 0;  ///< number of paths after that
};

/// An area of the picture: what is seen of one part in one colour.
struct VectorFill {
    std::string object; ///< MeshGroup::object of the part; empty where it has no name
    glm::vec3 color{0}; ///< RGB, 0 to 1, in steps of 1/255 as pictures have them
    /// The area's borders, closed without repeating a point, pixels as of VectorPoint. The area is
    /// to the same side of all of them, by the even-odd rule as by the nonzero one. Areas that
    /// touch have the points of their common border in common, bit by bit.
    std::vector<std::vector<glm::dvec2>> rings;
};

/// A drawing as paths, in the order in which they are drawn: hidden lines before visible ones, and
/// within both by kind.
struct VectorDrawing {
    glm::ivec2 size{1, 1};        ///< of the picture in pixels
    Style style{};                ///< the style; its paper has the colour of the background
    std::vector<Pen> pens{Pen{}}; ///< of visible paths; the first is the style's own
    /// Pens of hidden paths, likewise.
    std::vector<Pen> hidden_pens{Style{}.hidden_pen};
    std::vector<MeshGroup> groups;     ///< groups of the pieces; empty if none are known
    std::vector<VectorPath> paths;     ///< in the order in which they are drawn
    std::optional<PenTravel> travel{}; ///< of a drawing for a plotter, which has no thinned paths
    double thinned_share = 0;          ///< of the length of all lines: VectorPath::thinned
    /// Areas under the lines, which do not overlap; find_fills() finds them.
    std::vector<VectorFill> fills{};
};

/// How intervals become paths.
struct VectorOptions {
    /// The mesh that the lines were extracted from: pieces then know their object and material, and
    /// paths their curves, those of circles that the mesh was cut from, too.
    const Mesh* mesh = nullptr;
    /// Outlines that LineVisibility::outlines() or Renderer::read_outlines() found with the
    /// intervals; only a style with pens for outlines needs them.
    std::span<const OutlinePart> outlines{};
    double tolerance = 0.05; ///< pixels by which simplified paths may differ, at least 0
    bool plotter = false;    ///< order, turn and join paths for the least travel of the pen
};

/// The drawing of intervals that LineVisibility::find() or Renderer::read_intervals() found for
/// this camera. It has hidden lines if the style draws them and `intervals` has them. Throws
/// UsageError for a line set, a camera or a style that a renderer does not take.
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
    double value = 0;     ///< the number
    Unit unit = Unit::px; ///< its unit
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
    bool turns = false; ///< the page may lie on its side, as the drawing does
};

/// "a0" to "a6", "letter", "legal", "tabloid", or width and height as "300x200mm". Throws
/// UsageError that lists these.
LINEATLAS_API Page parse_page(std::string_view text);

/// The style for a picture of that size in pixels that is scaled to fit on a page. If the style's
/// lengths grow with the picture (Style::made_for), they become lengths on paper, 96 pixels to an
/// inch, whatever the size of the page. Other styles do not change. Throws UsageError if the margin
/// leaves no room.
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
    bool curves = true;     ///< write VectorPath::curves as arcs, else as chords
    bool fit_arcs = false;  ///< find arcs in paths without curves (docs/vector.md)
    std::string title = "Line drawing"; ///< of the document
    std::string description{};          ///< the settings that made it, for people
    std::string certificate{};          ///< result of a check of the drawing, as metadata; empty:
                                        ///< none
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
    std::string certificate{}; ///< result of a check of the drawing, as a comment; empty: none
};

/// The drawing as DXF of AutoCAD 2004, ASCII, in millimetres of the page from its lower left
/// corner. Throws UsageError as to_svg() does.
LINEATLAS_API std::string to_dxf(const VectorDrawing& drawing, const DxfOptions& options = {});

/// How a drawing is written as JSON.
struct JsonOptions {
    bool tags = true;          ///< the pieces of each path
    std::string description{}; ///< the settings that made it, for people
    std::string certificate{}; ///< result of a check of the drawing; empty: none
    glm::dvec3 origin{0};      ///< added to points in space: LoadedMesh::origin
};

/// The drawing as JSON (docs/vector.md). Throws UsageError as to_svg() does.
LINEATLAS_API std::string to_json(const VectorDrawing& drawing, const JsonOptions& options = {});

} // namespace lineatlas
