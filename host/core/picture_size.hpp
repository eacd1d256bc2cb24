#pragma once

#include <glm/vec2.hpp>

namespace lineatlas {

/// The longest side of a picture. On longer ones floats can't tell texels apart.
constexpr int longest_picture_side = 65536;
/// Throws UsageError for a picture that is longer, or empty.
void check_picture(glm::ivec2 size);

} // namespace lineatlas
