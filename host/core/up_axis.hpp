#pragma once

#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The axis that points upwards in most files of a format.
enum class UsualUp { y, z };

/// y or z: which way a model stands. Most things are as heavy to the left as to the right and in
/// front as behind, but not below as above, and they stand on something flat: the axis is taken
/// along which area is spread less evenly and one end is flat, the other not. Unless that is clear,
/// what is usual stays. docs/input.md has the formula.
glm::vec3 guess_up(const Mesh& mesh, UsualUp usual);

} // namespace lineatlas
