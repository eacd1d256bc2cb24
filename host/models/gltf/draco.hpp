#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas::gltf {

struct DracoMesh {
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    double step = 0; ///< of the grid that positions lie on; 0: on none
};

/// What KHR_draco_mesh_compression holds. `position`: the number of its attribute that positions
/// are. `of`: for what is refused.
DracoMesh decode_draco(std::string_view packed, std::uint64_t position, const std::string& of);

} // namespace lineatlas::gltf
