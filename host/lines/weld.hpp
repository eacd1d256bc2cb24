#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/objects.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// A mesh whose equal positions share one vertex and in which no triangle stands twice.
struct WeldedMesh {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> triangle_group; ///< per triangle; 0 if the mesh has no groups
    std::vector<std::vector<std::uint32_t>> polylines; ///< repeated neighbours removed
    std::vector<std::uint32_t> triangle_source;        ///< index into Mesh::triangles
    /// Per polyline, per vertex: index into Mesh::positions.
    std::vector<std::vector<std::uint32_t>> polyline_sources;
    std::vector<PolylineKind> polyline_kinds;
    std::vector<std::uint32_t> vertex_sources; ///< index into Mesh::positions
    std::vector<std::uint32_t> object_ends;    ///< per object the end of its vertices
    OddTriangles odd;                          ///< but not those without area
    double precision = 0;                      ///< Mesh::precision
    /// Per triangle whether its last two corners have changed places; empty if none have.
    std::vector<bool> turned{};

    /// The corner of its source triangle that corner k of a triangle is.
    int source_corner(std::size_t triangle, int k) const {
        return k > 0 && !turned.empty() && turned[triangle] ? 3 - k : k;
    }
};

/// Merges vertices of exactly equal position, drops triangles that lose a corner by that, and keeps
/// one of several triangles over the same three vertices. Exporters write two-sided faces as two
/// coincident triangles, which would make every edge non-manifold. Vertices come by object, and
/// none belongs to two. Throws UsageError if an index of a position or of a group is out of range
/// or missing, or if a position is not finite.
WeldedMesh weld(const Mesh& mesh, const MeshObjects& objects = {});

} // namespace lineatlas
