#pragma once

#include <optional>
#include <span>

#include "base/vertex_pairs.hpp"
#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/mesh.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Mesh::known_edges between welded vertices: the kinds of edges that the file gives, in place of
/// angles.
class KnownEdges {
  public:
    /// The mesh must outlive it. Throws UsageError when an index is out of range.
    KnownEdges(const Mesh& mesh, const WeldedMesh& welded);

    /// Whether the file names the kind of every edge. Edges that it does not name are within a face
    /// then.
    bool all() const { return all_; }

    /// Whether the faces of an edge continue each other smoothly.
    bool smooth(const MeshEdge& edge) const;

    /// Whether the edge is a line however little it is bent.
    bool drawn(const MeshEdge& edge) const;

    /// As classify() of edges.hpp, for edges of a mesh with all() and for edges that are drawn().
    std::optional<LineKind> classify(const MeshEdge& edge, const WeldedMesh& mesh, double bend,
                                     const LineOptions& options) const;

  private:
    /// Nothing: the file does not name the edge.
    std::optional<KnownEdge::Kind> kind_of(const MeshEdge& edge) const;

    std::span<const KnownEdge> edges_;
    std::optional<VertexPairs> by_vertices_; ///< of `edges_`
    bool all_ = false;
};

} // namespace lineatlas
