#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// A perspective camera as a person describes it: where the eye is, what it looks at.
struct View {
    glm::vec3 eye{0, 0, 1};    ///< where the eye is, in model units
    glm::vec3 target{0, 0, 0}; ///< the point it looks at
    glm::vec3 up{0, 1, 0};     ///< upwards in the picture; of any length above 0
    float fov_y = 0.6981317F;  ///< vertical field of view in radians (40 degrees)
    float near = 0;            ///< distance of the near plane; 0: fitted to the bounds
    float far = 0;             ///< distance of the far plane; 0: fitted to the bounds
};

/// What glClipControl() was told where it was called; the default is GL's.
struct ClipControl {
    bool upper_left = false;  ///< GL_UPPER_LEFT: y of clip space points down in the framebuffer
    bool zero_to_one = false; ///< GL_ZERO_TO_ONE: z of clip space goes from 0 to w, not from -w
};

/// What the pipeline sees of a camera: the matrices and the viewport that a program draws with.
///
/// Depth may be reversed, and the far plane infinitely far away: the projection says so itself. Eye
/// space is GL's, looking along -z (for a perspective projection +z will do).
struct Camera {
    glm::mat4 view{1};       ///< world to eye space
    glm::mat4 projection{1}; ///< eye to clip space
    glm::ivec2 size{1, 1};   ///< viewport in pixels
    glm::ivec2 origin{0, 0}; ///< its lower left corner in the framebuffer
    ClipControl clip{};      ///< the conventions of `projection`

    /// World to clip space.
    glm::mat4 clip_from_world() const { return projection * view; }

    /// The centre of projection in homogeneous world coordinates; w is 0 for a parallel projection.
    /// With GL's default clip control and depth that is not reversed.
    LINEATLAS_API glm::vec4 eye() const;
};

/// A part of a picture: pixels from its lower left corner.
struct PictureTile {
    glm::ivec2 low{0, 0};  ///< its lower left corner in the picture
    glm::ivec2 size{0, 0}; ///< width and height
};

/// Matrices for `view`. Planes left at 0 are fitted to `bounds`, which must not be empty then.
/// Throws UsageError when a number is not finite, the eye is the target, `up` is along the line of
/// sight, the field of view is not in (0, pi) or the size is not positive.
LINEATLAS_API Camera make_camera(const View& view, glm::ivec2 size, const Bounds& bounds);

/// A view from the front, right and above in which all `points` just fit, with a small margin.
/// There must be at least one. `up` must be a unit axis.
LINEATLAS_API View frame_points(std::span<const glm::vec3> points, glm::ivec2 size,
                                glm::vec3 up = {0, 1, 0}, float fov_y = View{}.fov_y);

/// The same seen from another side: `toward_eye` is a unit vector, not along `up`.
View frame_points_from(glm::vec3 toward_eye, std::span<const glm::vec3> points, glm::ivec2 size,
                       glm::vec3 up = {0, 1, 0}, float fov_y = View{}.fov_y);

} // namespace lineatlas
