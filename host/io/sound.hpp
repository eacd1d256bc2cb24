#pragma once

#include "lineatlas/io.hpp"

namespace lineatlas {

// Checks of everything that the reading process sends, before any other code uses it: that process
// may have been taken over by its file.

/// Whether load_mesh() could have made the model of some file: it keeps all promises of the header
/// of load_mesh(), and all numbers are within the ranges that readers check.
bool is_sound(const LoadedMesh& loaded);

/// Whether read_image() could have made the image of some file.
bool is_sound(const Image& image);

} // namespace lineatlas
