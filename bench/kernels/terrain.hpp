#pragma once

#include "common.hpp"

namespace lineatlas::bench {

/// A square grid of hills: a mesh of any size whose triangles are neighbours in memory as a real
/// mesh's are. Seen from above and aside all of it is in view.
struct Terrain {
    std::vector<float> vertices;          ///< 3 each
    std::vector<std::uint32_t> triangles; ///< 3 each
    std::vector<Segment> segments;        ///< edges with the triangles beside them, all creases
    std::uint32_t vertex_count = 0;
    glm::vec4 eye{};
    glm::mat4 clip_from_world{1};
};

/// With at least `triangles` triangles and exactly `segments` segments.
Terrain make_terrain(std::uint32_t triangles, std::uint32_t segments);

} // namespace lineatlas::bench
