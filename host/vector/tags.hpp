#pragma once

#include <string>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Where a path comes from, for people and small programs: "object door; material oak; entity #317;
/// edges 12-57 57-60", entities of a STEP file and positions of the mesh counted from 0. Each
/// object, material, entity and edge once, in order.
std::string tags_text(const VectorDrawing& drawing, const VectorPath& path);

} // namespace lineatlas
