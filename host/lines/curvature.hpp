#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "diffusion.hpp"
#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// One of the two principal curvatures of a surface, per vertex: above 0 where the surface bends
/// away from its normal, as a ball does.
struct PrincipalCurvature {
    std::vector<float> k;            ///< 1 / radius
    std::vector<glm::vec3> way;      ///< unit direction in which it bends so, of either sign
    std::vector<glm::vec3> gradient; ///< of k
    std::vector<float> slope;        ///< of k along `way`: its derivative there
};

/// How a surface bends at its vertices.
struct Curvatures {
    PrincipalCurvature most, least; ///< the greater and the lesser of the two
};

/// A mesh as the surface that its vertices were taken from. Its normals are smoothed step by step,
/// and its curvature follows from how they turn (Rusinkiewicz, "Estimating Curvatures and Their
/// Derivatives on Triangle Meshes", 2004).
class SmoothedSurface {
  public:
    /// The mesh must outlive it. `faces`: those of the surface.
    SmoothedSurface(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                    std::span<const std::uint32_t> faces);

    /// Smooths normals further, to a standard deviation of so many mean edges. It must not be less
    /// than before.
    void smooth_to(float edges);

    /// The curvatures. Their gradients are smoothed once more, by a third of the variance.
    Curvatures curvatures() const;

    /// The standard deviation of all smoothing of the gradients in curvatures(), in the mesh's
    /// units.
    float deviation() const;

    /// The gradient over a triangle of a function with these values at its corners.
    glm::vec3 gradient(std::uint32_t face, glm::vec3 values) const;

  private:
    void find_normals();
    void find_directions(Curvatures& found) const;
    void find_gradients(PrincipalCurvature& found) const;

    const WeldedMesh& mesh_;
    std::span<const std::uint32_t> faces_;
    Diffusion diffusion_;
    std::vector<glm::vec4> normals_; ///< the fourth is 0
    float variance_ = 0;             ///< by which they were smoothed
};

} // namespace lineatlas
