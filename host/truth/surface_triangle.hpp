#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/surface.hpp"

namespace lineatlas {

/// A triangle of a known surface, whose places are given as shares of its corners.
class SurfaceTriangle {
  public:
    /// `triangle`: index into KnownSurfaces::of_triangle of a triangle with a surface. `corners`:
    /// the places of its corners. `known` must outlive this object.
    SurfaceTriangle(const KnownSurfaces& known, std::uint32_t triangle,
                    const std::array<glm::dvec3, 3>& corners);

    struct Place {
        glm::dvec3 at;
        glm::dvec3 normal; ///< outwards, of length 1; 0 at a pole or a tip
    };
    /// A place and its normal. A surface far from its triangle is not believed.
    Place place(const glm::dvec3& shares) const;
    /// The parameters of a place. At a pole or a tip one parameter may have any value; on the way
    /// there it keeps its value.
    glm::dvec2 parameters(const glm::dvec3& shares) const;

  private:
    static constexpr std::size_t none = 3;

    const PlacedSurface& placed_;
    const SurfaceShape& shape_;
    const std::array<glm::dvec2, 3>& parameters_;
    std::array<glm::dvec3, 3> corners_;
    double longest_ = 0; ///< of the sides
    glm::dmat3 normal_turn_;
    std::size_t tip_ = none; ///< a corner
    int free_ = 0;           ///< the parameter that may have any value there
};

} // namespace lineatlas
