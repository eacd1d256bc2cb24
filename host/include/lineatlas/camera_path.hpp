#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/export.hpp"

/// @file
/// Cameras of turntables, and of paths through views.
/// @code{.cpp}
/// const Axis axis{.point = 0.5F * (lines.bounds.min + lines.bounds.max)};
/// const View first = frame_points(swept(lines.vertices, axis), size); // shows all, all around
/// const View quarter = turned(first, axis, 0.25);
/// const CameraPath path{{{0, first}, {48, door}, {96, roof}}};
/// const View between = path.view(24);
/// @endcode

namespace lineatlas {

/// A line in space. Functions that take an axis throw UsageError unless its direction is a unit
/// vector.
struct Axis {
    glm::vec3 point{0, 0, 0};     ///< any point on the line
    glm::vec3 direction{0, 1, 0}; ///< a unit vector; upwards
};

/// `view` carried around the axis by `turn` full turns, counter-clockwise seen from above. Its near
/// and far planes are fitted anew.
LINEATLAS_API View turned(const View& view, const Axis& axis, double turn);

/// Points around the space that the given points sweep over in a full turn. A view by
/// frame_points() of these points shows a turning model completely. Throws UsageError unless all
/// points are finite.
LINEATLAS_API std::vector<glm::vec3> swept(std::span<const glm::vec3> points, const Axis& axis);

/// A camera that moves smoothly through views, each at a frame, and rests between two equal views.
class LINEATLAS_API CameraPath {
  public:
    /// A view that the camera passes through.
    struct Key {
        double frame = 0; ///< need not be whole
        View view;        ///< the view at that frame
    };

    /// Throws UsageError unless there is a key and frames rise, from -1e6 to 1e6.
    explicit CameraPath(std::vector<Key> keys);

    int first_frame() const; ///< the first whole frame
    int last_frame() const;  ///< the last whole frame; below the first if there is none
    /// The view at a frame, which need not be whole; before the first key and after the last one
    /// the view of that key. Planes and projection are those of the key before.
    View view(double frame) const;

  private:
    std::vector<Key> keys_;
};

} // namespace lineatlas
