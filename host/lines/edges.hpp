#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// An undirected mesh edge with the first two triangles that use it.
struct MeshEdge {
    std::uint32_t p, q; ///< vertices, in the winding of `face_a`
    std::uint32_t face_a,
        face_b;               ///< LA_NO_FACE if there is none; `face_b` may be LA_FACE_FLIPPED
    std::uint32_t face_count; ///< triangles that use the edge: 1 boundary, above 2 non-manifold
};

/// Every edge of the mesh once, ordered by its smaller vertex, then the larger. Any number of
/// triangles may share an edge, in any winding, which a halfedge structure cannot hold
/// (docs/decisions/lines.md).
std::vector<MeshEdge> mesh_edges(const WeldedMesh& mesh);

/// Per vertex the first of its edges to larger vertices, and at last the number of all edges.
std::vector<std::uint32_t> first_edges(std::size_t vertices, std::span<const MeshEdge> edges);

/// Unit normals per triangle in double precision; zero for a triangle without area.
std::vector<glm::dvec3> face_normals(const WeldedMesh& mesh);

/// Lets a neighbour stand for every triangle without area in the edges' `face_a` and `face_b`: such
/// a sliver has no direction, and must neither make nor hide a crease or a silhouette. The
/// neighbour is the one across the sliver's longest edge, or across that one's if it is a sliver
/// too. `normals`: face_normals().
void replace_slivers(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
                     std::vector<MeshEdge>& edges);

/// The number of triangles without any area. Other triangles without a normal are thin; large
/// polygons are cut into such.
std::size_t flat_face_count(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals);

/// The bend between the two faces of every edge, in radians from 0 (flat) to pi (folded back); 0
/// for edges without two faces.
std::vector<double> bends_of(const std::vector<MeshEdge>& edges,
                             const std::vector<glm::dvec3>& normals);

/// Faces one of whose edges bends by less than this, in radians, are flat there: 0.5 degrees.
inline constexpr double flat_bend = 0.008726646259971648;

/// Per triangle whether it is flat across some edge, which bends by less than `flat`.
std::vector<bool> flat_faces(std::size_t triangles, std::span<const MeshEdge> edges,
                             std::span<const double> bends, double flat = flat_bend);

/// The crease angle if LineOptions::crease is nothing. An edge that bends less is no crease, and
/// one that bends more is a crease unless it is noise (noisy_creases.hpp). 28.8 degrees: the sides
/// of a prism with twelve corners bend by 30 degrees, those of one with thirteen by 27.7. The
/// middle tells them apart best, however coarsely a file rounds its coordinates.
inline constexpr float least_crease_angle = 0.5026548F;

/// The kind of line that an edge with this bend is under `options`; nothing if it is never one.
std::optional<LineKind> classify(const MeshEdge& edge, const WeldedMesh& mesh, double bend,
                                 const LineOptions& options);

} // namespace lineatlas
