#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// What is seen at a place of the picture.
enum class Ground : std::uint8_t {
    model,    ///< a face
    around,   ///< background that reaches the picture's border
    enclosed, ///< background that the model surrounds, as in a through hole
};

/// The background of a picture, on a grid of texels as large as its pixels. In pictures with a side
/// of more than 2048 pixels the texels are larger.
class Background {
  public:
    Background(const LineSet& lines, const Camera& camera);

    /// What is seen at a place in pixels from the upper left corner.
    Ground at(glm::dvec2 place) const;
    /// The side of a texel in pixels.
    double texel() const { return texel_; }

  private:
    std::size_t row(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x);
    }
    void cover(const LineSet& lines, const Camera& camera);
    void find_regions();

    double texel_;
    glm::ivec2 size_; ///< in texels
    std::vector<Ground> texels_;
};

} // namespace lineatlas
