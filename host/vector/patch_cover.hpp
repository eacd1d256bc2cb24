#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// What the triangles of smooth surfaces (Contours::faces) hide.
class PatchCover {
  public:
    /// Keeps a reference to the lines.
    PatchCover(const LineSet& lines, const Camera& camera);

    /// Whether a triangle hides a place, if it is connected with triangle `face` by others within
    /// `reach` pixels of the place.
    bool hides(std::uint32_t face, const VectorPoint& place, double reach);

  private:
    struct Corner {
        glm::dvec2 at;
        double depth;
        bool is_seen; ///< before the eye
    };
    Corner project(std::uint32_t vertex) const;

    const LineSet& lines_;
    glm::dmat4 clip_from_world_;
    glm::dvec2 size_;                      ///< of the picture
    std::vector<glm::uvec2> beside_edge_;  ///< per edge, the first two triangles there
    std::vector<std::uint32_t> asked_;     ///< per triangle, the last query that found it
    std::vector<std::uint32_t> waiting_{}; ///< triangles that are to be asked
    std::uint32_t query_ = 0;
};

} // namespace lineatlas
