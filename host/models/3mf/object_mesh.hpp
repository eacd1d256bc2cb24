#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "library.hpp"

namespace lineatlas::threemf {

/// The material of a triangle.
struct Material {
    std::string name;
    std::optional<glm::vec3> color;

    bool operator==(const Material&) const = default;
};

/// The mesh of an object as the file has it.
struct ObjectMesh {
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Material> materials;
    std::vector<std::uint32_t> triangle_material; ///< per triangle
};

/// Reads the mesh of an object. Refuses beam lattices and meshes that only stand for slices.
ObjectMesh read_mesh(const Handle& model, const Handle& object);

} // namespace lineatlas::threemf
