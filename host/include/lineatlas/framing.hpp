#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/lines.hpp"

/// @file
/// The points that a camera frames for a whole model.
/// @code{.cpp}
/// const Framing framing = framing_of(lines);
/// const View all = frame_points(framing.points, size);
/// if (!framing.note.empty()) std::cerr << framing.note << '\n';
/// @endcode

namespace lineatlas {

/// The points that a camera should show to frame a whole model.
struct Framing {
    std::vector<glm::vec3> points; ///< for frame_points()
    std::string note{}; ///< a line for people if a small part lies far from the rest, else empty
};

/// The vertices of a model, except those of a small part far away: one with at most a thousandth of
/// the triangles and lines, so far away that it would make the picture at least twice as wide. The
/// note names such a part. A part of up to 2 % so far away is framed, and the note says how wide it
/// makes the picture.
LINEATLAS_API Framing framing_of(const LineSet& lines);

} // namespace lineatlas
