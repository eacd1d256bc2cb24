#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"

/// @file
/// The line or the face at a point of a picture.
/// @code{.cpp}
/// LineVisibility visibility{lines};
/// if (const std::optional<Pick> pick = visibility.pick(camera, {320, 240}, 4))
///     std::cout << (pick->kind ? "a line" : "a face") << " of object " << pick->object << '\n';
/// @endcode

namespace lineatlas {

/// The thing at a point of a picture: a line near the point, or else the face of a triangle.
struct Pick {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< there is none
    /// For a line: index into LineSet::segments, and into LineSet::sources, which has the edge of
    /// the mesh. none: no line is near enough.
    std::uint32_t segment = none;
    std::optional<LineKind> kind{}; ///< of the line
    /// For a face: index into LineSet::triangles and into LineSet::triangle_sources.
    std::uint32_t triangle = none;
    std::uint32_t object = 0; ///< index into LineSet::objects; 0 if there are none
    /// Window position on the line or face: pixels from the lower left corner of the viewport.
    glm::vec2 position{0, 0};
    float distance = 0; ///< pixels from the given point to `position`; 0 for a face
    glm::vec3 world{0}; ///< the point of the model at `position`
};

} // namespace lineatlas
