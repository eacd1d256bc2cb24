#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "accessors.hpp"
#include "buffers.hpp"
#include "document.hpp"

namespace lineatlas::gltf {

/// A primitive of a mesh as triangles and lines, in the mesh's own coordinates.
struct Primitive {
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::vector<std::uint32_t>> lines;
    std::optional<std::uint64_t> material;
    /// The joints that move each position, and their weights, in fours. Empty without joints.
    std::vector<Values> joints{}, weights{};
    double step = 0;     ///< of the grid that positions lie on; 0: no grid
    bool points = false; ///< it has only points, which are not drawn
};

/// The primitives of a mesh in the pose of its own weights of morph targets, or of `node_weights`
/// if the node has some. Refuses indices beyond the positions.
std::vector<Primitive> read_mesh(const Document& document, Buffers& buffers, std::uint64_t mesh,
                                 const Json* node_weights);

} // namespace lineatlas::gltf
