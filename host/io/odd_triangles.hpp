#pragma once

#include <string>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Adds notes about the triangles that extract_lines() left out or repaired to those of a model.
void add_notes(const OddTriangles& odd, std::vector<std::string>& notes);

} // namespace lineatlas
