#pragma once

#include <string>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Where a path comes from, for people and small programs: "object door; material oak; edges 12-57
/// 57-60", positions of the mesh counted from 0. Each object, material and edge once, in order.
std::string tags_text(const VectorDrawing& drawing, const VectorPath& path);

} // namespace lineatlas
