#pragma once

#include <string>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// "A3" of a page that has a name, else its width and height, as "300 x 200 mm".
std::string page_name(const Page& page);

} // namespace lineatlas
