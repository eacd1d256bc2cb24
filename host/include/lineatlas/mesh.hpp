#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/surface.hpp"

/// @file
/// Meshes, also of a program's own arrays.
/// @code{.cpp}
/// Mesh own = make_mesh({.positions = vertices, .stride = 6, .indices = indices});
/// const std::vector<glm::vec3> wire{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
/// add_polyline(own, wire);
/// @endcode

namespace lineatlas {

/// The object and the material of triangles. A mesh edge between two different groups is a material
/// line.
struct MeshGroup {
    std::string object;   ///< OBJ `o`/`g` name; empty where the file names none
    std::string material; ///< OBJ `usemtl` name; empty where the file names none
    /// Diffuse colour as on the screen (sRGB-coded), each channel 0 to 1; nothing where none is
    /// known.
    std::optional<glm::vec3> color{};
};

/// An edge whose kind the file itself gives, as files of exact surfaces do (STEP). It runs along
/// edges of triangles, or along a polyline.
struct KnownEdge {
    /// What a KnownEdge is.
    enum class Kind : std::uint32_t {
        sharp,  ///< between two faces that meet at an angle: a crease however small that is
        smooth, ///< between two faces that meet smoothly
        seam,   ///< where a face that goes round, as a cylinder's, meets itself: never a line
        free,   ///< of one face only: a boundary
        wire,   ///< of no face: a polyline; says nothing of edges of triangles
        marked, ///< a crease by hand, however small its angle; says nothing of other edges
    };
    std::uint32_t from = 0;  ///< index into Mesh::positions
    std::uint32_t to = 0;    ///< index into Mesh::positions
    Kind kind = Kind::sharp; ///< what it is
    std::uint32_t edge = 0;  ///< number of the file's own edge, of which this is a piece
};

/// The circle or ellipse that an edge of a file runs along: center + cos(t) u + sin(t) v.
struct EdgeCurve {
    glm::dvec3 center{0}; ///< in model units
    glm::dvec3 u{0};      ///< half an axis
    glm::dvec3 v{0};      ///< half the other, at right angles; of a circle as long as `u`
};

/// What a polyline of a mesh is.
enum class PolylineKind : std::uint8_t {
    file,     ///< a line that the file has, or the program's own
    section,  ///< a part of the outline of a cut (lineatlas/section.hpp)
    hatching, ///< on the face of a cut
    trail,    ///< of a part that explode() has moved (lineatlas/explode.hpp)
};

/// An indexed triangle soup with optional polylines, as read from a file or built by a program.
///
/// Equal positions need not share an index: extract_lines() merges them. Nothing is assumed
/// about manifoldness, orientation or closedness.
struct Mesh {
    std::vector<glm::vec3> positions;          ///< finite, in model units
    std::vector<glm::uvec3> triangles;         ///< indices into `positions`
    std::vector<std::uint32_t> triangle_group; ///< per triangle, index into `groups`; or empty
    std::vector<MeshGroup> groups;             ///< empty when `triangle_group` is empty
    std::vector<std::vector<std::uint32_t>> polylines; ///< lines given in the file (OBJ `l`)
    /// Per triangle the number of its object, which moves on its own
    /// (LineOptions::separate_objects). Empty: triangles of groups with one name are an object.
    std::vector<std::uint32_t> triangle_object{};
    /// The same per polyline. Empty: polylines are one object, the last.
    std::vector<std::uint32_t> polyline_object{};
    /// If there are any, they decide which edges are creases and boundaries. Angles between
    /// triangles do not, because inside a curved face they come from the tessellation. If all of
    /// them are KnownEdge::Kind::marked or wire, angles decide about all other edges.
    std::vector<KnownEdge> known_edges{};
    /// Per number of a file's edge (KnownEdge::edge) its circle or ellipse, or nothing if it is
    /// neither. It may end before the last number. Paths along such an edge are written as that
    /// curve (SvgOptions::curves).
    std::vector<std::optional<EdgeCurve>> edge_curves{};
    /// Per number of a file's edge its number in the file, as #12 of STEP, or 0 if that is not
    /// known. It may end before the last number.
    std::vector<std::uint32_t> edge_entities{};
    /// What each polyline is. Empty: all are PolylineKind::file.
    std::vector<PolylineKind> polyline_kind{};
    /// Normals of the surface itself at the corners of triangles, three unit vectors to a triangle,
    /// outwards as its winding says; zero where there is none, as at the tip of a cone. Files of
    /// exact surfaces have them. Smooth silhouettes (Silhouettes) take them in place of means of
    /// triangles. Empty: none are known.
    std::vector<glm::vec3> corner_normals{};
    /// The surfaces that curved triangles approximate; their normals are those of `corner_normals`.
    /// Smooth silhouettes by the exact method lie on them. Empty: none are known.
    KnownSurfaces surfaces{};
    /// Distance, in model units, by which a position may be off its exact place, as in files that
    /// round to a grid, or a chord off its curve. Things nearer to each other than that count as
    /// touching. 0: the precision of floats.
    float precision = 0;

    /// True if the mesh has nothing to draw.
    bool empty() const { return triangles.empty() && polylines.empty(); }
};

/// A program's own arrays, as it has them for GL. Normals are not among them: lines come from
/// positions alone, and vertices that only differ in normals are one.
struct MeshArrays {
    std::span<const float> positions;           ///< x, y, z of each vertex
    std::size_t stride = 3;                     ///< floats, not bytes, to the next vertex
    std::span<const std::uint32_t> indices{};   ///< three per triangle; none: vertices as they come
    std::span<const std::uint32_t> materials{}; ///< a number per triangle; none: all are one
};

/// A copy of the arrays as a mesh, whose groups are the materials, named by their numbers. The last
/// vertex may end before its stride does. Throws UsageError when the arrays do not fit each other:
/// an index that no vertex has, corners or materials that are not three or one to a triangle, one
/// or two floats after the last vertex.
LINEATLAS_API Mesh make_mesh(const MeshArrays& arrays);

/// Adds the triangles of a polygon, in its winding; it may be concave, and need not be flat. Its
/// corners are indices into Mesh::positions; fewer than three add nothing. Groups, objects and
/// normals of the new triangles are the caller's to add. Throws UsageError when an index is out of
/// range.
LINEATLAS_API void add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners);

/// Adds a line of the program's own, drawn from point to point (LineKind::file).
LINEATLAS_API void add_polyline(Mesh& mesh, std::span<const glm::vec3> points);

/// An axis-aligned box. A box that holds nothing has min > max.
struct Bounds {
    glm::vec3 min{std::numeric_limits<float>::infinity()};  ///< least coordinates
    glm::vec3 max{-std::numeric_limits<float>::infinity()}; ///< greatest coordinates
};

/// The box around the positions that triangles or polylines use. Throws UsageError when an index is
/// out of range.
LINEATLAS_API Bounds bounds_of(const Mesh& mesh);

} // namespace lineatlas
