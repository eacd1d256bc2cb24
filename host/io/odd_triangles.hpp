#pragma once

#include <string>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Adds what extract_lines() left out or repaired to the notes about a model.
void add_notes(const OddTriangles& odd, std::vector<std::string>& notes);

} // namespace lineatlas
