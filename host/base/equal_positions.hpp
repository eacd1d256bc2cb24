#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// Per position the index of an equal one, the same for all equal positions; -0 equals 0. Which
/// of the equal positions that is may differ from run to run, since several threads look for it.
std::vector<std::uint32_t> equal_positions(std::span<const glm::vec3> positions);

} // namespace lineatlas
