#pragma once

#include <string>
#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Where a path comes from, for people and small programs: "object door; material oak; entity #317;
/// edges 12-57 57-60", entities of a STEP file and positions of the mesh counted from 0. Each
/// object, material, entity and edge once, in order.
std::string tags_text(const VectorDrawing& drawing, const VectorPath& path);

/// What a STEP file calls the edges and faces that a path shows: "#317", each once, in order.
std::vector<std::string> entities_of(const VectorPath& path);

} // namespace lineatlas
