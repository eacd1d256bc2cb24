#include "surface_view.hpp"

#include <cmath>

#include <glm/matrix.hpp>

#include "depth_tolerance.hpp"

namespace lineatlas {

SurfaceView surface_view(const Camera& camera) {
    // Double precision, because large numbers cancel at the eye.
    const glm::dmat4 world =
        glm::inverse(glm::dmat4{camera.projection} * glm::dmat4{camera.view}); // from clip space
    SurfaceView view{};
    view.parallel = camera.projection[2][3] == 0;
    const float per_depth = view.parallel ? 2.0F : std::abs(2.0F / camera.projection[3][2]);
    view.bend = depth_tolerance(camera) * per_depth;
    if (view.parallel) {
        view.world_from_screen =
            glm::mat4{glm::dmat4{world[0], world[1], world[3] + world[2], -world[2]}};
        return view;
    }
    const glm::dvec4 eye = world[2] / world[2].w;
    view.world_from_screen =
        glm::mat4{glm::dmat4{world[0] - eye * world[0].w, world[1] - eye * world[1].w,
                             world[3] - eye * world[3].w, eye}};
    return view;
}

} // namespace lineatlas
