#pragma once

#include <string>

namespace lineatlas::apps {

/// The version, and for each optional or separately installed part whether it is available.
std::string version();

} // namespace lineatlas::apps
