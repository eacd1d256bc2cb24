#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/export.hpp"

namespace lineatlas {

/// A line in space. What takes one throws UsageError unless its direction is a unit vector.
struct Axis {
    glm::vec3 point{0, 0, 0};     ///< any on it
    glm::vec3 direction{0, 1, 0}; ///< a unit vector; upwards
};

/// `view` carried around the axis by a share of a full turn, counter-clockwise seen from above. Its
/// planes are fitted anew.
LINEATLAS_API View turned(const View& view, const Axis& axis, double turn);

/// Points that bound what the given ones sweep over in a full turn: what frame_points() must frame
/// so that a turning model never leaves the picture. Throws UsageError unless they are finite.
LINEATLAS_API std::vector<glm::vec3> swept(std::span<const glm::vec3> points, const Axis& axis);

/// A camera that moves smoothly through views, each at a frame, and rests between two that are
/// alike.
class LINEATLAS_API CameraPath {
  public:
    /// A view that is passed.
    struct Key {
        double frame = 0; ///< need not be whole
        View view;        ///< what is seen then
    };

    /// Throws UsageError unless there is a key and frames rise, from -1e6 to 1e6.
    explicit CameraPath(std::vector<Key> keys);

    int first_frame() const; ///< the first whole one
    int last_frame() const;  ///< the last whole one; below the first where there is none
    /// At a frame, between whole ones too; before the first key and behind the last as there.
    /// Planes and projection are those of the key before.
    View view(double frame) const;

  private:
    std::vector<Key> keys_;
};

} // namespace lineatlas
