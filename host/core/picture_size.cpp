#include "picture_size.hpp"

#include <algorithm>
#include <string>

#include "limits.hpp"

namespace lineatlas {

void check_picture(glm::ivec2 size) {
    if (std::min(size.x, size.y) >= 1 && std::max(size.x, size.y) <= longest_picture_side) return;
    throw UsageError("a picture of " + written_size(size) +
                     " can't be drawn: each side must be 1 to " +
                     std::to_string(longest_picture_side) + " pixels");
}

} // namespace lineatlas
