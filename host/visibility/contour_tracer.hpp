#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "compute/stages/silhouette_chains.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Finds the silhouettes of known surfaces (Contours::surfaces). The signs of n.v at the corners of
/// triangles tell which silhouettes there are, as in the stage `contour` (Hertzmann and Zorin
/// 2000). Roots on the surface itself tell where they run. A branch that begins and ends within one
/// triangle is missed.
class ContourTracer {
  public:
    /// `lines` need not outlive it.
    explicit ContourTracer(const LineSet& lines);

    /// `outside`: see sees_from_outside().
    compute::TracedSilhouettes trace(const Camera& camera, bool outside) const;

  private:
    class Frame;

    bool traces(std::uint32_t face) const {
        return surfaces_.of_triangle[face] != KnownSurfaces::none;
    }
    /// Leaves out smooth patches with faces that have no surface. Silhouettes go on from face to
    /// face, so all faces of a patch are traced or none is.
    void leave_out_mixed();

    /// A triangle of contours.
    struct Face {
        glm::uvec3 corners{0}; ///< into corners_
        glm::uvec3 edges{0};   ///< as in Contours::faces
        Segment segment{};     ///< the candidate that stands for the triangle
    };
    /// A corner that triangles of a smooth patch have in common.
    struct Corner {
        glm::dvec3 at{0}, normal{0}; ///< normal: 0 at a tip
        std::uint32_t place = 0;     ///< 3 times the number of a face that has the corner, plus
                                     ///< which of its corners it is
    };

    KnownSurfaces surfaces_;
    std::vector<Face> faces_;
    std::vector<Corner> corners_;
    std::size_t edge_count_ = 0;
    std::vector<compute::FaceRange> traced_;
};

} // namespace lineatlas
