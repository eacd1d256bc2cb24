#pragma once

#include <cstdint>
#include <vector>

#include "lineatlas/lines.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The circles that edges of a mesh were cut from.
///
/// Consecutive chords are parts of one circle if there are at least four, if they are equally long
/// and turn by equal angles of at most 15 degrees, together by 30 at least, and if their corners
/// are within 0.0005 of the radius of the circle. The first and the last one may be shorter. Rings
/// of fewer than 24 corners stay polygons: an arc over a chord of theirs would reach beyond the
/// outlines that end at its corners, by more than one percent of the radius. A corner at which
/// another line of the model ends is the end of an arc. Several segments in a row may be one chord.
/// A vertex at which more than 16 segments meet is the end of a chord.
/// If chords before or behind go on to bend as an arc does, the arc is a part of a curve of another
/// kind, and left out.
class MeshCircles {
  public:
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< no circle

    explicit MeshCircles(const LineSet& lines);

    /// The circle of which a segment of the line set is a chord or a part of one, or `none`.
    std::uint32_t circle_of(std::uint32_t segment) const {
        return segment < circle_of_.size() ? circle_of_[segment] : none;
    }
    /// In the coordinates of LineSet::vertices.
    const EdgeCurve& circle(std::uint32_t number) const { return circles_[number]; }
    bool empty() const { return circles_.empty(); }

  private:
    std::vector<std::uint32_t> circle_of_; ///< per segment; empty where there are no circles
    std::vector<EdgeCurve> circles_;
};

} // namespace lineatlas
