#pragma once

#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The axis that points upwards in most files of a format.
enum class UsualUp { y, z };

/// y or z: which way a model stands. Most things weigh as much on the left as on the right, and as
/// much in front as behind. But they weigh unlike above and below, and stand on something flat. So
/// the result is the axis along which area is spread less evenly and only one end is flat. If
/// neither axis is clearly ahead, it is the usual one. docs/input.md has the formula.
glm::vec3 guess_up(const Mesh& mesh, UsualUp usual);

} // namespace lineatlas
