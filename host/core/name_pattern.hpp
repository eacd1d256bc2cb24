#pragma once

#include <string>

#include <fnmatch.h>

namespace lineatlas {

/// Whether a name is what a pattern stands for: `*` for any letters, `?` for one, `[...]` for one
/// of these.
inline bool matches(const std::string& pattern, const std::string& name) {
    return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

} // namespace lineatlas
