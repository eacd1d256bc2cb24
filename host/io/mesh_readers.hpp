#pragma once

#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Each reader goes through a file once from end to end. It allocates memory for a count only if
/// the file has that much data. Throws FileError at the first error, a missing end included.
Soup read_ply(const SourceFile& source);
Soup read_off(const SourceFile& source);
/// The corners of a facet stand in it as coordinates: equal ones become one.
Soup read_stl(const SourceFile& source);
/// By OpenMesh's own reader.
Soup read_om(const SourceFile& source);

} // namespace lineatlas
