#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "compute/stages/silhouette_chains.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The view by which silhouettes of surfaces are found.
struct TraceView {
    glm::dvec4 eye; ///< as Camera::eye()
    glm::dmat4 clip_from_world;
    glm::dvec2 size;      ///< of the picture, pixels
    bool outside = false; ///< see sees_from_outside()
};

/// The silhouettes of known surfaces (Contours::surfaces). Which there are is told by the signs of
/// n.v at the corners of triangles, as the stage `contour` tells it (Hertzmann and Zorin 2000);
/// where they run, by roots on the surface itself. A branch that comes and goes within one triangle
/// is not seen.
class ContourTracer {
  public:
    /// `lines` need not outlive it.
    explicit ContourTracer(const LineSet& lines);

    compute::TracedSilhouettes trace(const TraceView& view) const;

  private:
    class Frame;

    bool traces(std::uint32_t face) const {
        return surfaces_.of_triangle[face] != KnownSurfaces::none;
    }
    /// Of a smooth patch all faces have surfaces, or none is traced: silhouettes go on across them.
    void leave_out_mixed();

    /// A triangle of contours.
    struct Face {
        glm::uvec3 corners{0}; ///< into corners_
        glm::uvec3 edges{0};   ///< as Contours::faces
        Segment segment{};     ///< that stands for it
    };
    /// A corner that triangles of a smooth patch have in common.
    struct Corner {
        glm::dvec3 at{0}, normal{0}; ///< normal: 0 at a tip
        std::uint32_t place = 0;     ///< 3 times a face that has it, and which of its corners it is
    };

    KnownSurfaces surfaces_;
    std::vector<Face> faces_;
    std::vector<Corner> corners_;
    std::size_t edge_count_ = 0;
    std::vector<compute::FaceRange> traced_;
};

} // namespace lineatlas
