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
    around,   ///< background
    enclosed, ///< background that one piece of the model surrounds, as in a through hole
};

/// The background of a picture, on a grid of texels as large as its pixels. In pictures with a side
/// of more than 2048 pixels the texels are larger. A piece of the model is a set of triangles that
/// are connected by common vertices. So the sky between sails and ropes, which are several pieces,
/// is around the model, and a hole of a plate is enclosed.
class Background {
  public:
    Background(const LineSet& lines, const Camera& camera);

    /// What is seen at a place in pixels from the upper left corner.
    Ground at(glm::dvec2 place) const;
    /// The side of a texel in pixels.
    double texel() const { return texel_; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(x);
    }
    void fill(int y, int first, int end, Ground ground);
    double texel_;
    glm::ivec2 size_; ///< in texels
    std::vector<Ground> texels_;
};

} // namespace lineatlas
