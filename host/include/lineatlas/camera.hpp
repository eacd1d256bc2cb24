#pragma once

#include <span>
#include <string_view>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

/// @file
/// Views, as people describe them, and cameras, as programs have them.
/// @code{.cpp}
/// const View front = frame_points_from(view_direction("front", {0, 1, 0}), lines.vertices, size);
/// const Camera whole = make_camera(front, size, lines.bounds);
/// const Camera own{.view = view, .projection = projection, .size = {width, height}};
/// @endcode

namespace lineatlas {

/// How points of space are projected onto the picture.
enum class Projection {
    perspective,  ///< lines of sight meet in the eye
    orthographic, ///< lines of sight are parallel: equal lengths look equal, near or far
};

/// "perspective" or "orthographic".
LINEATLAS_API std::string_view name_of(Projection projection);

/// The projection of that name; throws UsageError that lists both names.
LINEATLAS_API Projection parse_projection(std::string_view name);

/// A camera as a person describes it: where the eye is and what it looks at.
struct View {
    glm::vec3 eye{0, 0, 1};    ///< where the eye is, in model units
    glm::vec3 target{0, 0, 0}; ///< the point it looks at
    glm::vec3 up{0, 1, 0};     ///< upwards in the picture; of any length above 0
    float fov_y = 0.6981317F;  ///< vertical field of view in radians (40 degrees)
    float near = 0;            ///< distance of the near plane; 0: fitted to the bounds
    float far = 0;             ///< distance of the far plane; 0: fitted to the bounds
    /// An orthographic view shows as much as a perspective one does at its target: moving the eye
    /// away makes things smaller in both.
    Projection projection = Projection::perspective;
};

/// The height in model units that a view shows from the picture's lower border to its upper one; in
/// a perspective view the height at its target.
LINEATLAS_API float shown_height(const View& view);

/// The view with its eye moved along the line of sight so that it shows `height`, which must be
/// above 0: in orthographic projection a drawing to scale.
LINEATLAS_API View with_shown_height(const View& view, float height);

/// The direction from which a view looks at a model.
struct ViewDirection {
    glm::vec3 toward_eye{0, 0, 1}; ///< a unit vector
    glm::vec3 up{0, 1, 0};         ///< upwards in the picture; not along `toward_eye`
};

/// A direction by its name: "front", "back", "left", "right", "top", "bottom", "isometric",
/// "dimetric" (ISO 5456-3: depth at half the scale of width and height), or "AZIMUTH,ELEVATION" in
/// degrees: from the front to the right, and upwards. `up`: the upward axis of the model, a unit
/// axis. The front is the side that -y points to if `up` is z, else the side that z points to.
/// "left" looks from the left. Throws UsageError that lists all names.
LINEATLAS_API ViewDirection view_direction(std::string_view name, glm::vec3 up);

/// The arguments of glClipControl(), if the program calls it; the default is GL's.
struct ClipControl {
    bool upper_left = false;  ///< GL_UPPER_LEFT: y of clip space points down in the framebuffer
    bool zero_to_one = false; ///< GL_ZERO_TO_ONE: z of clip space goes from 0 to w, not from -w
};

/// A camera as the pipeline needs it: the matrices and the viewport that a program draws with.
///
/// Depth may be reversed, and the far plane may be infinitely far away; the projection matrix
/// tells. Eye space is GL's, looking along -z (a perspective projection may also look along +z).
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

/// Matrices for `view`. Near and far planes of 0 are fitted to `bounds`, which must not be empty
/// then. An orthographic view with fitted planes also shows things behind its eye. Throws
/// UsageError when a number is not finite, the eye is the target, `up` is along the line of sight,
/// the field of view is not in (0, pi) or the size is not positive.
LINEATLAS_API Camera make_camera(const View& view, glm::ivec2 size, const Bounds& bounds);

/// A view from the front, right and above in which all `points` just fit, with a small margin.
/// There must be at least one. `up` must be a unit axis.
LINEATLAS_API View frame_points(std::span<const glm::vec3> points, glm::ivec2 size,
                                glm::vec3 up = {0, 1, 0}, float fov_y = View{}.fov_y,
                                Projection projection = Projection::perspective);

/// The same as frame_points(), seen from another side.
LINEATLAS_API View frame_points_from(const ViewDirection& direction,
                                     std::span<const glm::vec3> points, glm::ivec2 size,
                                     float fov_y = View{}.fov_y,
                                     Projection projection = Projection::perspective);

} // namespace lineatlas
