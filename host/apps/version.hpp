#pragma once

#include <string>

namespace lineatlas::apps {

/// The version, and of each part that may be left out or installed apart whether it is here.
std::string version();

} // namespace lineatlas::apps
