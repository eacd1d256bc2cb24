#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <TopoDS_Shape.hxx>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas::brep {

/// How closely triangles follow curved faces.
struct Fineness {
    double deflection = 0; ///< the distance a chord may be off, in the shape's units
    double angle = 0;      ///< by which neighbouring chords may differ in direction, radians
};

/// A shape as triangles, with the edges between its faces. Faces that share an edge share its
/// positions.
struct ShapeMesh {
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> triangle_face; ///< per triangle, number of its face
    /// Per triangle and corner the face's outward unit normal there; zero if it has none.
    std::vector<std::array<glm::dvec3, 3>> normals;
    /// Per triangle and corner the parameters of the face's surface; zero if they are not known.
    std::vector<std::array<glm::dvec2, 3>> parameters;
    std::vector<TopoDS_Shape> faces;
    /// Per face its surface, if it is known, and whether du x dv points inwards.
    std::vector<std::optional<SurfaceShape>> surfaces;
    std::vector<bool> turned;
    std::vector<KnownEdge> edges; ///< KnownEdge::edge counts from 0
    std::uint32_t edge_count = 0;
    std::vector<TopoDS_Shape> edge_shapes;             ///< per number of an edge
    std::vector<std::optional<EdgeCurve>> edge_curves; ///< per number of an edge
    std::vector<std::vector<std::uint32_t>> lines;     ///< edges of no face
    std::size_t failed_faces = 0;                      ///< faces that could not be meshed
};

/// Meshes a shape without its own location. Throws exceptions of Open CASCADE.
ShapeMesh mesh_shape(const TopoDS_Shape& shape, const Fineness& fineness);

} // namespace lineatlas::brep
