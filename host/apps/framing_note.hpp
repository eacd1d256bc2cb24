#pragma once

#include <string>

#include "lineatlas/lines.hpp"

namespace lineatlas::apps {

/// What to say where a camera that frames all of a model shows most of it small, since a small part
/// lies far away; empty elsewhere. `origin`: of the lines, in the file's coordinates.
std::string framing_note(const LineSet& lines, glm::dvec3 origin);

} // namespace lineatlas::apps
