#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// What is seen at a point of a picture: a line that is near, or else the face of a triangle.
struct Pick {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< there is none
    /// Index into LineSet::segments, and so into LineSet::sources, which has the edge of the mesh;
    /// none: no line is near enough.
    std::uint32_t segment = none;
    std::optional<LineKind> kind{}; ///< of the line
    /// Of a face: index into LineSet::triangles, and so into LineSet::triangle_sources.
    std::uint32_t triangle = none;
    std::uint32_t object = 0; ///< index into LineSet::objects; 0 where there are none
    /// Window position of what was found: pixels from the lower left corner of the viewport.
    glm::vec2 position{0, 0};
    float distance = 0; ///< pixels to it from the point asked for; 0 for a face
    glm::vec3 world{0}; ///< the point of the model that is seen there
};

} // namespace lineatlas
