#pragma once

#include "lineatlas/io.hpp"

namespace lineatlas {

// What comes from the process that reads, checked whole before anything else looks at it: that
// process may have been taken over by its file.

/// Whether the model is one that load_mesh() could have made of some file: all that its header
/// promises, and no number that only a file's own reader would have kept within its range.
bool is_sound(const LoadedMesh& loaded);

/// The same of read_image().
bool is_sound(const Image& image);

} // namespace lineatlas
