#pragma once

#include <string>
#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// The origin of a path, for people and small programs: "object door; material oak; entity #317;
/// edges 12-57 57-60". Entities are those of a STEP file. Edges are pairs of positions of the mesh,
/// counted from 0. Each object, material, entity and edge comes once, in order.
std::string tags_text(const VectorDrawing& drawing, const VectorPath& path);

/// The entities of a STEP file whose edges and faces a path shows: "#317", each once, in order.
std::vector<std::string> entities_of(const VectorPath& path);

} // namespace lineatlas
