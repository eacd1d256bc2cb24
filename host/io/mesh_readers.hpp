#pragma once

#include "soup.hpp"
#include "source_file.hpp"

namespace lineatlas {

/// Each walks a file from end to end, once, and makes room for what it promises only where the file
/// has as much. Throws FileError at the first thing that is wrong, a missing end included.
Soup read_ply(const SourceFile& source);
Soup read_off(const SourceFile& source);
/// The corners of a facet stand in it as coordinates: equal ones become one.
Soup read_stl(const SourceFile& source);
/// By OpenMesh's own reader.
Soup read_om(const SourceFile& source);

} // namespace lineatlas
