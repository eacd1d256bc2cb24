#pragma once

#include "common.hpp"

namespace lineatlas::bench {

/// Hills on a square grid: a mesh of any size, whose neighbouring triangles lie close in memory as
/// in real meshes. The camera looks down from one side and has all of it in view.
struct Terrain {
    std::vector<float> vertices;          ///< 3 each
    std::vector<std::uint32_t> triangles; ///< 3 each
    std::vector<Segment> segments;        ///< edges with the triangles beside them, all creases
    std::uint32_t vertex_count = 0;
    glm::vec4 eye{};
    glm::mat4 clip_from_world{1};
};

/// A terrain with at least `triangles` triangles and exactly `segments` segments.
Terrain make_terrain(std::uint32_t triangles, std::uint32_t segments);

} // namespace lineatlas::bench
