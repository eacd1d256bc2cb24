#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Ends of lines that are hidden from a chord of a round rim on. The rim itself is drawn along its
/// curve, so such a line ends at the curve.
class RimEnds {
  public:
    /// Finds the ends, while all lines are chords. `size`: of the picture, pixels. `is_bent` tells
    /// whether the chord of a piece of a path will be bent.
    RimEnds(const std::vector<VectorPath>& paths, glm::dvec2 size,
            const std::function<bool(const VectorPath&, const VectorPiece&)>& is_bent);

    /// Moves the ends of the same paths, once they are bent.
    void move(std::vector<VectorPath>& paths) const;

  private:
    struct Touch {
        std::uint32_t path;
        bool at_end;
        std::uint32_t rim; ///< a path
    };

    glm::dvec2 size_;
    std::vector<Touch> touches_;
};

} // namespace lineatlas
