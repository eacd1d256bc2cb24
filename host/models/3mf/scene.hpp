#pragma once

#include "io/soup.hpp"
#include "library.hpp"

namespace lineatlas::threemf {

/// All items of the model's build list in their places. Each is a tree of parts. Refuses an empty
/// list.
Soup read_scene(const Handle& model);

} // namespace lineatlas::threemf
