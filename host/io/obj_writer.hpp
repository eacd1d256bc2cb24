#pragma once

#include <string>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The mesh as an OBJ file, with its groups (but not their colours) and polylines. Positions are
/// written so that reading gives the same floats.
std::string to_obj(const Mesh& mesh);

} // namespace lineatlas
