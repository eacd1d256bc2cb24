#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// The part that a triangle belongs to, and the colour in which it is seen.
struct Look {
    std::string object;
    glm::uvec3 color{0}; ///< 0 to 255
};

/// How the triangles of a line set look.
struct FaceLooks {
    std::vector<Look> looks;                ///< no two are equal
    std::vector<std::uint32_t> of_triangle; ///< index into `looks`
};

/// The looks by one camera. The stage `fill` of pictures colours triangles alike, except on smooth
/// surfaces: it lights these by corner normals, and a look is lit by the normal of its triangle.
FaceLooks face_looks(const LineSet& lines, const Camera& camera, const Fill& fill);

} // namespace lineatlas
