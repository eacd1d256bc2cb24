#pragma once

#include <string>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// The name of a page such as "A3", or else its width and height such as "300 x 200 mm".
std::string page_name(const Page& page);

} // namespace lineatlas
