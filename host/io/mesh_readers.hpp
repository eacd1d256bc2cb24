#pragma once

#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Each reader goes through a file once from end to end. It allocates memory for a count only if
/// the file has that much data. Throws FileError at the first error, a missing end included.
Soup read_ply(const SourceFile& source);
Soup read_off(const SourceFile& source);
/// An STL facet holds the coordinates of its corners. Equal corners become one.
Soup read_stl(const SourceFile& source);
/// Reads with OpenMesh's own reader.
Soup read_om(const SourceFile& source);

} // namespace lineatlas
