#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// What a camera should show that frames a whole model.
struct Framing {
    std::vector<glm::vec3> points; ///< for frame_points()
    std::string note{}; ///< a line for people if a small part lies far from all else, or nothing
};

/// The vertices of a model, but for a part that is at most a thousandth of its triangles and lines
/// and lies so far away that a picture of all would be at least twice as wide for its sake. The
/// note says so; and where up to 2 % lie so far, which are framed, how wide it makes the picture.
LINEATLAS_API Framing framing_of(const LineSet& lines);

} // namespace lineatlas
