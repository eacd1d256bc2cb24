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
    double step = 0; ///< of the grid that positions lie on; 0: no grid
};

/// A mesh from KHR_draco_mesh_compression. `position`: the number of the attribute with the
/// positions. `of`: names the mesh in refusals.
DracoMesh decode_draco(std::string_view packed, std::uint64_t position, const std::string& of);

} // namespace lineatlas::gltf
