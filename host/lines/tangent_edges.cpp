#include "tangent_edges.hpp"

#include "diagonal.hpp"
#include "surface/round_surface.hpp"

namespace lineatlas {
namespace {

constexpr double same_place = 3e-7; ///< of the model's diagonal

class Surfaces {
  public:
    Surfaces(const WeldedMesh& mesh, const KnownSurfaces& known,
             std::span<const SurfaceShape> shapes)
        : mesh_(mesh), known_(known), shapes_(shapes),
          tolerance_(same_place * diagonal_of(mesh.vertices)) {}

    /// Whether the surface beside an edge goes on beyond it. A file may cut a cylinder in two.
    bool go_on(const MeshEdge& edge) const {
        const std::uint32_t a = edge.face_a, b = edge.face_b & LA_FACE_INDEX;
        return lies_on_surface_of(a, b) && lies_on_surface_of(b, a);
    }

  private:
    /// Whether a face lies on the surface of another.
    bool lies_on_surface_of(std::uint32_t face, std::uint32_t other) const {
        if (known_.empty()) return false;
        const std::uint32_t surface = known_.of_triangle[mesh_.triangle_source[other]];
        if (surface == KnownSurfaces::none) return false;
        const PlacedSurface& placed = known_.surfaces[surface];
        for (int k = 0; k < 3; ++k)
            if (!holds_place(shapes_[placed.shape], placed,
                             mesh_.vertices[mesh_.triangles[face][k]], tolerance_))
                return false;
        return true;
    }

    const WeldedMesh& mesh_;
    const KnownSurfaces& known_;
    std::span<const SurfaceShape> shapes_;
    double tolerance_;
};

} // namespace

std::vector<std::uint32_t> tangent_edges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                                         const KnownEdges& known, const KnownSurfaces& surfaces,
                                         std::span<const SurfaceShape> shapes) {
    const Surfaces beside{mesh, surfaces, shapes};
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < edges.size(); ++i)
        if (edges[i].face_count == 2 && known.smooth(edges[i]) && !beside.go_on(edges[i]))
            found.push_back(i);
    return found;
}

} // namespace lineatlas
