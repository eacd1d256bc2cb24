#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Smooths values at the vertices of a surface as heat flows, however large and thin the triangles
/// are: by linear finite elements (cotangents), in implicit steps.
class Diffusion {
  public:
    /// `faces`: the triangles of the surface.
    Diffusion(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
              std::span<const std::uint32_t> faces);

    /// Takes a step. `variance`: that of the kernel along each axis of the surface. The kernel has
    /// thicker tails than a Gaussian.
    void smooth(std::vector<glm::vec4>& values, float variance) const;

    /// A third of the area of the triangles about each vertex; 0 where the surface has none.
    const std::vector<float>& areas() const { return areas_; }
    /// The mean length of the surface's edges.
    float mean_edge() const { return mean_edge_; }

  private:
    void find_neighbours(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges);
    void add_face(const WeldedMesh& mesh, glm::uvec3 face);
    void add_flow(std::uint32_t a, std::uint32_t b, float flow);
    glm::vec4 gain(const std::vector<glm::vec4>& values, std::size_t vertex) const;

    std::vector<std::uint32_t> offsets_, neighbours_; ///< of vertices
    std::vector<float> flows_;                        ///< to neighbours, per difference
    std::vector<float> outflows_;                     ///< their sums, of vertices
    std::vector<float> areas_;
    float mean_edge_ = 0;
};

} // namespace lineatlas
