#pragma once

#include "lineatlas/io.hpp"

namespace lineatlas {

// Checks of everything that the reading process sends, before any other code uses it: that process
// may have been taken over by its file.

/// Whether the model is one that load_mesh() could have made of some file: all that its header
/// promises, and no number that only a file's own reader would have kept within its range.
bool is_sound(const LoadedMesh& loaded);

/// The same of read_image().
bool is_sound(const Image& image);

} // namespace lineatlas
