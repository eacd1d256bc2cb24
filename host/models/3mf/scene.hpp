#pragma once

#include "io/soup.hpp"
#include "library.hpp"

namespace lineatlas::threemf {

/// All items of the model's build list in their places, a tree of parts each. Refuses an empty
/// list.
Soup read_scene(const Handle& model);

} // namespace lineatlas::threemf
