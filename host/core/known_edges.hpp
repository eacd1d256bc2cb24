#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/mesh.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Mesh::known_edges between welded vertices: what the file says of edges, in place of angles.
class KnownEdges {
  public:
    /// Throws UsageError when an index is out of range.
    KnownEdges(const Mesh& mesh, const WeldedMesh& welded);

    /// Whether the file says anything.
    bool any() const { return !kinds_.empty(); }

    /// As classify() of edges.hpp, for a mesh with any().
    std::optional<LineKind> classify(const MeshEdge& edge, const WeldedMesh& mesh, double bend,
                                     const LineOptions& options) const;

  private:
    std::unordered_map<std::uint64_t, KnownEdge::Kind> kinds_;
};

} // namespace lineatlas
