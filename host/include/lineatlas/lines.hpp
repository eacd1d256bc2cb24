#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"
#include "lineatlas/progress.hpp"
#include "segment_table.h"

/// @file
/// The lines of a mesh.
/// @code{.cpp}
/// LineSet found = extract_lines(mesh, {.crease = 0.7F}); // radians
/// std::cout << found.segments.size() << " segments in " << found.path_count << " paths\n";
/// move_vertices(found, new_positions); // the mesh bends, and keeps its triangles
/// @endcode

namespace lineatlas {

/// Where a line comes from. An edge that qualifies as several kinds takes the first of: file,
/// section, boundary (non-manifold edges included), crease, material, silhouette; it may be tangent
/// besides. docs/lines.md has the rules.
enum class LineKind : std::uint32_t {
    crease = LA_KIND_CREASE,         ///< bent, by the rule of `LineOptions::crease`
    boundary = LA_KIND_BOUNDARY,     ///< an edge of one triangle, or of more than two
    material = LA_KIND_MATERIAL,     ///< between triangles of different groups
    silhouette = LA_KIND_SILHOUETTE, ///< between a front and a back face, chosen per frame (§3.1)
    file = LA_KIND_FILE,             ///< given as a polyline in the model
    intersection = LA_KIND_INTERSECTION, ///< where parts pass through each other; no edge
    section = LA_KIND_SECTION,           ///< the outline of a cut: Section::mesh has it
    hatching = LA_KIND_HATCHING,         ///< on the faces of a cut
    /// Along the crest of an undesigned surface, such as a scan; no edge.
    ridge = LA_KIND_RIDGE,
    valley = LA_KIND_VALLEY, ///< the same along its furrows
    /// Where two surfaces of a file meet smoothly (KnownEdge::Kind::smooth); not where one surface
    /// is cut in two.
    tangent = LA_KIND_TANGENT,
    /// The axis of a round surface of Mesh::surfaces, or two crossed lines if the axis is seen end
    /// on. No edge.
    centre = LA_KIND_CENTRE,
    trail = LA_KIND_TRAIL, ///< from where a part belongs to where explode() has moved it; no edge
};

/// The names of LineKind in the order of its numbers, as options and files have them.
inline constexpr std::array<std::string_view, LA_KIND_COUNT> line_kind_names{
    "crease",   "boundary", "material", "silhouette", "file",   "intersection", "section",
    "hatching", "ridge",    "valley",   "tangent",    "centre", "trail"};

/// A set of line kinds: bit `1 << kind`.
using LineKindMask = std::uint32_t;
/// All kinds.
inline constexpr LineKindMask all_line_kinds = (1U << LA_KIND_COUNT) - 1;
/// The kinds that are drawn unless others are asked for. Style::more_lines adds to them.
inline constexpr LineKindMask usual_line_kinds =
    all_line_kinds & ~(1U << LA_KIND_TANGENT | 1U << LA_KIND_CENTRE);
/// The set of that kind alone.
constexpr LineKindMask mask_of(LineKind kind) {
    return 1U << static_cast<std::uint32_t>(kind);
}

/// Where silhouettes run. docs/lines.md has the rules.
enum class Silhouettes : std::uint32_t {
    automatic, ///< smooth on patches of a mesh that are smooth, else along edges
    smooth,    ///< where normals, interpolated over triangles, are at a right angle to the view
    mesh,      ///< along edges between a front and a back face
};

/// The names of Silhouettes in the order of its numbers, as options have them.
inline constexpr std::array<std::string_view, 3> silhouettes_names{"auto", "smooth", "mesh"};

/// Which edges of a mesh are lines, and how they are chained.
struct LineOptions {
    LineKindMask lines = all_line_kinds; ///< kinds: others are not extracted
    /// Radians, 0 to pi: every edge bent by more is a crease. Nothing: edges bent by more than 28.8
    /// degrees are creases, except noise of scans and seams (docs/lines.md).
    std::optional<float> crease{};
    /// Radians, 0 to pi. A path goes on through a vertex where it turns by no more than this.
    float chain_angle = 1.134464F;
    /// Objects move on their own (Renderer::set_transforms). Then nothing is welded or cut between
    /// objects: where two objects touch, each has a line of its own. Objects are those of
    /// Mesh::triangle_object, or groups of one name.
    bool separate_objects = false;
    /// Make creases of edges of KnownEdge::Kind::smooth, too: where a fillet ends.
    bool smooth_edges = false;
    /// Methods other than `exact` and `atlas` draw silhouettes along edges in any case.
    Silhouettes silhouettes = Silhouettes::automatic;
};

/// An object of a model: it moves on its own.
struct LineObject {
    std::string name;               ///< MeshGroup::object; empty where objects are numbers
    std::uint32_t first_vertex = 0; ///< of its part of LineSet::vertices
    std::uint32_t vertex_count = 0; ///< in that part
};

/// The place of a segment in the `Mesh` that it was extracted from. If the segment is a part of an
/// edge, the whole edge.
struct LineSource {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< there is none
    std::uint32_t from = none; ///< index into Mesh::positions of the segment's start p
    std::uint32_t to = none;   ///< index into Mesh::positions of its end q
    /// Index into Mesh::triangles of a triangle that has both ends. For a ridge or a valley, the
    /// triangle that it runs through, and for a centre line, a triangle of its surface; `from` and
    /// `to` are none then. None for a polyline of the file.
    std::uint32_t triangle = none;
    /// For an intersection, the other one of the two triangles; `from` and `to` are none then.
    std::uint32_t crossing = none;
};

/// A vertex that is no position of the mesh: a line begins or ends there within an edge.
struct CutVertex {
    std::uint32_t vertex; ///< of LineSet::vertices
    std::uint32_t from;   ///< of LineSet::vertices, one end of the edge
    std::uint32_t to;     ///< of LineSet::vertices, its other end
    float share;          ///< of the way from one to the other
};

/// Odd triangles that extract_lines() left out or repaired.
struct OddTriangles {
    std::size_t repeated = 0;  ///< over the same corners as another, in any winding: left out
    std::size_t collapsed = 0; ///< two corners at one place: left out
    std::size_t flat = 0;      ///< no area: taken to lie in the plane of a neighbour
};

/// Numbers of edges of the mesh that extract_lines() did not take for lines.
struct LeftOut {
    std::size_t noisy_creases = 0; ///< bent by more than 28.8 degrees, but noise of a surface
    std::size_t seams = 0;         ///< boundaries and creases across which faces continue
    std::size_t cut_seams = 0;     ///< seams with a part that is a line
    /// Pairs of boundaries that became one edge. Rounding had kept them apart, or corners of one
    /// boundary within the other.
    std::size_t cracks = 0;
};

/// Milliseconds that steps of extract_lines() took.
struct LineTimes {
    double creases = 0;       ///< telling creases of the model from noise
    double seams = 0;         ///< finding where faces continue across edges
    double intersections = 0; ///< finding intersections of parts
    double ridges = 0;        ///< finding ridges and valleys
    double centres = 0;       ///< finding centre lines
};

/// Where silhouettes of smooth surfaces may run: one segment through a triangle, from edge to edge,
/// at places that depend on the view. The last segments of a LineSet stand for such triangles, one
/// each: both faces of the segment are the triangle, its ends are two of the triangle's corners.
struct Contours {
    std::vector<ContourCorner> corners; ///< a vertex with the normal of a smooth patch there
    std::vector<glm::uvec2> edges;      ///< into `corners`
    /// Indices into `edges`, around the triangle of each such segment; with LA_CONTOUR_TURNED for
    /// an edge that runs the other way.
    std::vector<glm::uvec3> faces;
    /// The number of segments just before those of the contours that stand for the same
    /// silhouettes, along edges.
    std::uint32_t replaced = 0;
    /// The surfaces on which silhouettes by the exact method lie, with one entry for each of
    /// `faces` in place of a triangle of the mesh. Empty: silhouettes go by normals.
    KnownSurfaces surfaces{};

    bool empty() const { return faces.empty(); } ///< silhouettes run along edges everywhere
};

/// Edges of a mesh that are lines, or may become one, chained into paths: the input of the
/// pipeline.
struct LineSet {
    std::vector<glm::vec3> vertices;   ///< welded: no two are equal, each is used
    std::vector<glm::uvec3> triangles; ///< into `vertices`; no duplicates, no repeated corners
    std::vector<Segment> segments;     ///< paths one after the other; silhouette candidates last
    std::vector<LineSource> sources;   ///< per segment
    std::uint32_t path_count = 0;      ///< `Segment::path` is below this
    std::array<std::uint32_t, LA_KIND_COUNT> kind_counts{}; ///< segments per kind
    Bounds bounds;                                          ///< of `vertices`
    /// The colours of the mesh's groups that triangles have, each once and fewer than `no_color`
    /// (triangles of any more colours have none).
    std::vector<glm::vec3> colors;
    /// Per triangle an index into `colors`, or `no_color`; empty where no triangle has a colour.
    std::vector<std::uint16_t> triangle_color;
    static constexpr std::uint16_t no_color = 0xFFFF; ///< of triangles without a colour
    std::vector<MeshGroup> groups{};                  ///< of the mesh
    std::vector<std::uint32_t> triangle_group{};      ///< per triangle, into `groups`; or empty
    /// Per vertex one of the mesh's positions that were welded into it; for a cut vertex the nearer
    /// end of its edge, for an end of a centre line one of its surface.
    std::vector<std::uint32_t> vertex_sources{};
    std::vector<std::uint32_t> triangle_sources{}; ///< per triangle, index into Mesh::triangles
    /// With LineOptions::separate_objects; their vertices come in this order.
    std::vector<LineObject> objects{};
    OddTriangles odd{}; ///< what was left out or repaired
    LeftOut left_out{}; ///< what might have been a line
    LineTimes times{};  ///< how long the steps took
    /// Vertices that are no positions of the mesh. They follow the others of their object.
    std::vector<CutVertex> cut_vertices{};
    Contours contours{}; ///< see LineOptions::silhouettes
    float precision = 0; ///< Mesh::precision
};

/// A part of a visible line that has the background on one side: of the model's outline.
struct OutlinePart {
    std::uint32_t segment = 0; ///< index into LineSet::segments
    glm::vec2 start{0, 0};     ///< window position, pixels from the lower left, as of an Interval
    glm::vec2 end{0, 0};       ///< the same of its end
};

/// Welds the mesh by exactly equal position, classifies its edges and chains them into paths.
/// Throws UsageError if an index of a position or of a group is out of range, if
/// Mesh::triangle_group is not as long as Mesh::triangles, if a position is not finite, or if an
/// angle is out of range. Throws Cancelled if `progress` returns false.
LINEATLAS_API LineSet extract_lines(const Mesh& mesh, const LineOptions& options = {},
                                    const Progress& progress = {});

/// Moves vertices and normals as Renderer::set_transforms() does, for make_vector_drawing(), for
/// LineVisibility, and for a renderer whose objects stay at these places. Throws UsageError as
/// Renderer::set_transforms() does.
LINEATLAS_API void move_objects(LineSet& lines, std::span<const glm::mat4> world_from_object);

/// Hides objects as Renderer::set_hidden() does, for the same uses as move_objects(): their lines
/// become points, which nothing draws. Hide objects in a copy, because they cannot be shown again.
/// Throws UsageError for an object that does not exist.
LINEATLAS_API void hide_objects(LineSet& lines, std::span<const std::uint32_t> objects);

/// Moves the vertices to where they are if Mesh::positions are `positions`: for a mesh that bends
/// and stretches, but keeps its triangles. Lines keep their kinds and edges. Smooth surfaces stay
/// smooth, with normals of the moved triangles. Renderer::set_positions() of LineSet::vertices
/// shows the change. Throws UsageError if there are fewer positions than the vertices come from, or
/// if one is not finite; then nothing has changed.
LINEATLAS_API void move_vertices(LineSet& lines, std::span<const glm::vec3> positions);

} // namespace lineatlas
